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

// `tables` must be those of the scene's level. Results live in the frame's arena.
VisibleFaces find_visible_faces(const FrameContext& context, const ViewFrame& view,
                                const LevelTables& tables);

}  // namespace temblor::render
