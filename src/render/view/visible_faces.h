// Stage 2. ViewFrame -> VisibleFaces: the world's faces that the eye may see, front to back.
// Abrash, "Quake's Visible-Surface Determination" and "The Big Picture": leaves of the potentially visible
// set are marked, then the tree is walked front to back, whole subtrees outside the frustum left out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "render/view/face_opacity.h"
#include "render/view/level_tables.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Smaller is nearer. World faces and leaves share one sequence, each number used once.
using SortKey = std::int32_t;
constexpr SortKey kNotVisited = 0;

struct VisibleFace {
  world::FaceIndex face;
  SortKey key;
};

struct VisibleFaces {
  std::span<const VisibleFace> faces;           // in key order, all turned towards the eye
  std::span<const VisibleFace> deferred_faces;  // alike: those that something shows through
  std::span<const FaceOpacity> opacities;       // as given
  std::span<const SortKey> leaf_keys;         // by leaf: where its brush models belong; kNotVisited: not seen
  std::span<const std::uint8_t> node_marked;  // by node: not 0 when a leaf below it may be seen
  std::uint32_t faces_in_pvs = 0;
};

// `opacities` are the world's. `io_pvs_row` is scratch that keeps its capacity between frames.
VisibleFaces find_visible_faces(const world::Level& level, const LevelTables& tables, const ViewFrame& view,
                                std::span<const FaceOpacity> opacities, bool use_pvs, base::Arena& arena,
                                std::vector<std::uint8_t>& io_pvs_row);

}  // namespace temblor::render
