// The polygons that are drawn: where a leaf touches one that is filled by more.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/bsp/leaf_portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// What a side shows; BrushSide::surface is its number.
struct Surface {
  formats::BspTexinfo texinfo;
  std::uint32_t keys = 0;  // into Draft::surface_keys
  bool operator==(const Surface&) const = default;
};

constexpr std::int32_t kUnlitTexinfo = 1;  // BspTexinfo::flags

struct TreeFace {
  Winding winding;
  PlaneIndex plane;  // seen from its front
  std::uint32_t surface;
  std::uint32_t node;                 // in whose plane it lies
  std::vector<std::uint32_t> leaves;  // from which it may be seen
};

// What somebody in one leaf sees between it and a neighbor, `towards_viewer` the plane that faces them;
// kNoSurface: nothing.
std::uint32_t surface_between(const TreeLeaf& here, const TreeLeaf& there, PlaneIndex towards_viewer,
                              std::span<const Brush> brushes);

// One for each portal through which something is seen; of liquids, the same from inside.
std::vector<TreeFace> make_faces(const Tree& tree, std::span<const LeafPortal> portals,
                                 std::span<const Brush> brushes);

// Neighbors of one node, plane and surface that are convex together become one.
void merge_faces(std::vector<TreeFace>& io_faces, const PlaneSet& planes);

// Cuts lit faces that reach over more than `texels` along their texture's axes.
void subdivide_faces(std::vector<TreeFace>& io_faces, std::span<const Surface> surfaces, double texels);

}  // namespace temblor::compiler
