// Marks on faces: bullet holes, scorches, and splatter that shots leave, and pictures that a game asks for.
// They are painted into the face's surface block when the block is built and cost nothing in later frames.
// Stock Quake has no marks; Abrash mentions splatters and dents composited onto surfaces as an advantage of
// surface caching ("Graphics Programming Black Book", chapter 69).
//
// The client owns one MarkSet per level and passes it with each Scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "math/vec.h"
#include "render/mark_picture.h"
#include "world/level.h"

namespace temblor::render {

enum class MarkKind : std::uint8_t { kBulletHole, kScorch, kSplatter, kPicture };

struct Mark {
  MarkKind kind{};
  // The center, in the space of the face's brush model, so that marks move with doors and lifts.
  math::Vec3 position_model{0.0f};
  // Units, 0.5 to 128. Half the longer side of a picture.
  float radius = 4;
  // Chooses one of the shapes and the rotation; pictures ignore it.
  std::uint32_t seed = 0;
  // Only for kPicture, and never null then.
  std::shared_ptr<const MarkPicture> picture{};
  // The direction of the picture's upper edge, not parallel to the face's normal. Any length but 0.
  math::Vec3 up_model{0, 0, 1};
  // Made by the game rather than by a shot: outlives the marks of shots.
  bool is_lasting = false;
};

// The marks of one level, by face.
class MarkSet {
 public:
  // A face that has this many marks loses one when another is added: the oldest mark of a shot, or, if there
  // is none, the oldest. A shot's mark is not added to a face that is full of lasting ones.
  static constexpr std::size_t kMarksPerFace = 16;

  // `radius` must be 0.5 to 128 (DCHECKed). Allocates memory for all of a face's marks at its first mark.
  void add(world::FaceIndex face, const Mark& mark);
  // Removes all marks that are not lasting.
  void remove_shots();
  void clear();

  // Oldest first. Valid until the next add() or clear().
  std::span<const Mark> marks_on_face(world::FaceIndex face) const;
  // A hash of the face's marks, in their order. Equal marks have equal revisions in any set; different marks
  // have different revisions except with a chance of 2^-64. 0 only for a face without marks. The surface
  // cache compares revisions to decide whether a block is up to date.
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
