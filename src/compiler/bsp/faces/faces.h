// Faces: the visible parts of sides, which are the portals between a leaf and a neighbor with a stronger
// fill.
//
//   make_faces -> place_faces (second_tree.h) -> merge_faces -> subdivide_faces -> LevelWriter
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/bsp/leaf_portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// The look of a side: a texture with its alignment, and the keys for its light. BrushSide::surface is its
// index.
struct Surface {
  formats::BspTexinfo texinfo;
  std::uint32_t keys = 0;  // into Draft::surface_keys
  bool operator==(const Surface&) const = default;
};

constexpr std::int32_t kUnlitTexinfo = 1;  // BspTexinfo::flags: liquids and sky

// A face on its way to the level.
struct TreeFace {
  Winding winding;
  PlaneIndex plane;  // the face is seen from the plane's front
  std::uint32_t surface;
  std::uint32_t node;                 // the node whose plane it is in
  std::vector<std::uint32_t> leaves;  // the leaves that list it
};

// The surface that one sees from one leaf at the border of a neighbor; kNoSurface: nothing. `toward_viewer`:
// the plane of the border, facing the first leaf.
std::uint32_t find_surface_between(const TreeLeaf& here, const TreeLeaf& there, PlaneIndex toward_viewer,
                                   std::span<const Brush> brushes);

// Makes a face for each portal through which something is visible; surfaces of liquids get one for each side.
std::vector<TreeFace> make_faces(const Tree& tree, std::span<const LeafPortal> portals,
                                 std::span<const Brush> brushes);

// Joins neighboring faces with the same node, plane and surface whose union is convex.
void merge_faces(std::vector<TreeFace>& io_faces, const PlaneSet& planes);

// Cuts lit faces that are longer than `texels` along one of their texture's axes: original engines limit the
// size of a face's light map.
void subdivide_faces(std::vector<TreeFace>& io_faces, std::span<const Surface> surfaces, double texels);

}  // namespace temblor::compiler
