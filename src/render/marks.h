// Marks that shots leave on faces: bullet holes, scorches, splatter. They are composed into the face's
// surface when it is built, and cost nothing after that (Abrash, "Quake's Lighting Model: Surface Caching").
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "math/vec.h"
#include "world/level.h"

namespace temblor::render {

enum class MarkKind : std::uint8_t { kBulletHole, kScorch, kSplatter };

struct Mark {
  MarkKind kind{};
  math::Vec3 position_model{0.0f};  // in the space of the face's model
  float radius = 4;                 // units, 0.5 to 128
  std::uint32_t seed = 0;           // its shape and turn
};

// The marks of one level. At most `kMarksAFace` on a face: then the oldest gives way.
class MarkSet {
 public:
  static constexpr std::size_t kMarksAFace = 16;

  // Asks the heap for room at the first mark of a face, and never again for that face.
  void add(world::FaceIndex face, const Mark& mark);
  void clear();

  // Oldest first.
  std::span<const Mark> of_face(world::FaceIndex face) const;
  // A hash of the face's marks, in their order: equal marks have equal revisions, in any set, and different
  // ones have different revisions but for a chance of 2^-64. 0 when the face has none.
  std::uint64_t revision(world::FaceIndex face) const;
  std::size_t size() const { return size_; }

 private:
  struct FaceMarks {
    std::vector<Mark> marks;
    std::uint64_t revision = 0;
  };
  std::unordered_map<std::uint32_t, FaceMarks> faces_;
  std::size_t size_ = 0;
};

}  // namespace temblor::render
