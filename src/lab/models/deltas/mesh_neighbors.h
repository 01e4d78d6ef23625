// The neighbors of a model's triangles across their edges. Vertices on the skin's seam are stored twice; here
// those in one place are one, so the seam has neighbors too.
#pragma once

#include <array>
#include <vector>

#include "base/arena.h"
#include "render/alias/alias_mesh.h"

namespace temblor::lab {

class MeshNeighbors {
 public:
  explicit MeshNeighbors(const render::AliasModel& model);

  // Whether these are the neighbors of the model, which may have the address of one from before.
  bool match(const render::AliasModel& model) const;

  static constexpr std::uint32_t kNone = 0xffffffffu;
  struct Side {
    std::uint32_t edge;      // shared with the neighbor
    std::uint32_t neighbor;  // triangle, or kNone
  };
  // The sides from corner 0, 1, and 2 to the next one.
  const std::array<Side, 3>& sides(std::size_t triangle) const { return sides_[triangle]; }
  std::size_t edge_count() const { return edge_count_; }

 private:
  std::vector<render::MeshTriangle> triangles_;
  const void* poses_;
  std::size_t pose_bytes_;
  std::vector<std::array<Side, 3>> sides_;
  std::size_t edge_count_ = 0;
};

// A walk around the visible side of a model.
struct VisibleWalk {
  std::span<const std::uint32_t> triangles;  // in the order of the walk
  std::size_t seeds = 0;
};

// Begins at the front triangle that is nearest, and crosses edges to front triangles. If `has_many_seeds`, it
// begins again at front triangles that were not reached, until there are none. Lives in `arena`.
VisibleWalk walk_visible_side(const render::TriangleJob& job, const MeshNeighbors& neighbors,
                              bool has_many_seeds, base::Arena& arena);

}  // namespace temblor::lab
