// Validation of a level. Every Bsp from read_bsp() satisfies these rules, so no other code needs to check
// them. (If a rule is broken, it first replaces the records that no game reaches, bsp/unused.h, and repairs
// others, bsp/repair.h.)
//
// numbers    finite, coordinates, axes and offsets within +-kBspMaxCoordinate
// planes     normals of length 1 (to 1 %); type 0-5; types 0-2 have exactly that axis, positive, as normal
// textures   present: width and height 1..kBspMaxTextureSize, and either all four mip levels of the stated
//            sizes (the smallest may be empty) or none; at most 256 colors of its own;
//            not present: all else empty
// texinfos   name a texture (which may be not present); axes may be zero or parallel
// edges      name vertices; surfedges name edges, and negating one is safe
// faces      3..kBspMaxFaceEdges surfedges, each ending at the vertex where the next starts; plane, texinfo
//            in range; side 0 or 1; light_offset >= -1 (whether the samples are inside of the lighting
//            depends on the size of the face; the level loader checks it)
// leaves     at least one, the first solid; contents kBspMinContents..-1; marksurfaces in range;
//            visibility_offset -1 or inside the visibility
// nodes      plane, faces, children in range
// clipnodes  plane in range, children clipnodes or contents
// models     at least one, the world; faces, heads in range; visible_leaves below the number of leaves
// trees      below a model's head, each node is reached exactly once, and by no other model unless both start
//            at the same head; clipnodes may be shared, but have no cycles; no path is longer than
//            kBspMaxTreeDepth, so that recursion is safe
// sums       the faces of all nodes, the faces of all models, the marksurfaces of all leaves and the
//            surfedges of all faces are each together at most as many as the array they point into, so that
//            visiting all of them takes time in proportion to the file
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "formats/levels/bsp.h"

namespace temblor::formats {

constexpr float kBspMaxCoordinate = 16777216.0f;  // 2^24: sums and products stay finite, integers exact
constexpr std::uint32_t kBspMaxTextureSize = 16384;
constexpr std::uint32_t kBspMaxFaceEdges = 512;  // known levels stay below 100
constexpr std::int32_t kBspMinContents = -16;
constexpr std::uint32_t kBspMaxTreeDepth = 2048;  // known levels stay below 200

// A violation of these rules, for an error message.
struct BspFault {
  BspLump lump;
  std::optional<std::size_t> record;  // nullopt: the whole lump
  std::string reason;
};

// Returns the first violation, or nullopt.
std::optional<BspFault> find_fault(const Bsp& bsp);

// The rules of single records, for find_fault() and for repair.
bool is_sane(const math::Vec3& vector);
bool is_sane(const BspTexinfo& texinfo);  // its axes and offsets
bool is_valid_plane(const BspPlane& plane);
std::int32_t find_plane_type(const math::Vec3& normal);  // 0 to 5
// Whether a child of a node, or a head of hull 0, exists.
bool is_node_or_leaf(const Bsp& bsp, std::int32_t child);
// Whether a child of a clipnode, or a head of hulls 1 to 3, exists or is contents.
bool is_clipnode_or_contents(const Bsp& bsp, std::int32_t child);

}  // namespace temblor::formats
