// Stage 2. ViewFrame -> VisibleFaces: the world's faces that may be visible, front to back.
//
//   1. The PVS of the eye's leaf marks leaves, their faces, and the nodes above them.
//   2. The marked part of the tree is walked front to back. Subtrees outside the frustum are skipped.
//   3. A leaf that is reached marks its faces; a node's faces are emitted after everything in front of it.
//
// Every face and leaf gets the next number of one sequence as its sort key, so keys increase front to back.
//
// Method: Michael Abrash, "Quake's Visible-Surface Determination" (Graphics Programming Black Book, chapter
// 64); faces stored on nodes and BSP order as the sort key: "Sorted Spans in Action" (chapter 67).
#pragma once

#include <cstdint>
#include <span>

#include "render/view/face_opacity.h"
#include "render/view/frame_context.h"
#include "render/view/level_tables.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Smaller is nearer. Faces and leaves of the world share one sequence; each number is used once.
using SortKey = std::int32_t;
constexpr SortKey kNotVisited = 0;

struct VisibleFace {
  world::FaceIndex face;
  SortKey key;
};

struct VisibleFaces {
  // In key order; only faces whose front is visible. Opaque faces, and faces that something shows through.
  std::span<const VisibleFace> faces;
  std::span<const VisibleFace> deferred_faces;
  // By texture index, for faces of the world.
  std::span<const FaceOpacity> opacities;
  // By leaf: the key for brush models in this leaf; kNotVisited if the leaf is not visible.
  std::span<const SortKey> leaf_keys;
  // By node: not 0 if a leaf below the node is potentially visible.
  std::span<const std::uint8_t> node_marked;
  std::uint32_t faces_in_pvs = 0;
};

// The leaves whose faces may be visible: bit i for leaf i + 1, because leaf 0 is the solid outside and has no
// faces. All leaves if the eye's leaf has no PVS. Valid until the next frame.
std::span<const std::uint8_t> find_leaves_in_pvs(const FrameContext& context, const ViewFrame& view);

// The faces of such leaves, as find_visible_faces().
VisibleFaces find_faces_in_leaves(const FrameContext& context, const ViewFrame& view,
                                  const LevelTables& tables, std::span<const std::uint8_t> leaves);

// `tables` must be those of the scene's level. Results live in the frame's arena.
VisibleFaces find_visible_faces(const FrameContext& context, const ViewFrame& view,
                                const LevelTables& tables);

}  // namespace temblor::render
