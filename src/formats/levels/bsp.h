// Compiled levels (.bsp): versions 29 (Quake), 30 (Half-Life), 2PSB, and BSP2 (large levels), in one struct
// with the widest type of each field.
//
//   header, 124 bytes     0  version i32: 29, 30, "2PSB", or "BSP2"
//                         4  15 x (offset i32, size i32), one for each lump
//   lumps, anywhere in the file, in any order
//   BSPX, optionally: more lumps with names (bsp/bspx.h)
//
//   models --> nodes --> leaves --> marksurfaces --> faces --> surfedges --> edges --> vertices
//     |          |          \--> visibility           |  \--> planes
//     |          \--> planes                          |--> texinfo --> textures
//     \--> clipnodes --> planes                       \--> lighting
//
// bsp/records.h shows the records of each lump. Versions 29, 2PSB, and BSP2 differ only in the width of their
// fields; bsp/half_life.h describes version 30. References between lumps are indices; read_bsp() validates
// all of them (bsp_validate.h), so other code needs no checks. src/world makes a playable level of a Bsp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/palette.h"
#include "math/vec.h"

namespace temblor::formats {

enum class BspVersion { k29, k2Psb, kBsp2, k30 };
const char* version_name(BspVersion version);  // "29", "2PSB", "BSP2", "30"

// The lumps, in the order of the header.
enum class BspLump : std::uint8_t {
  kEntities,
  kPlanes,
  kTextures,
  kVertices,
  kVisibility,
  kNodes,
  kTexinfo,
  kFaces,
  kLighting,
  kClipnodes,
  kLeaves,
  kMarksurfaces,
  kEdges,
  kSurfedges,
  kModels,
};
constexpr std::size_t kBspLumpCount = 15;
const char* lump_name(BspLump lump);    // "entities", "planes", ...
const char* record_name(BspLump lump);  // name of one record: "plane", "texture", ...

// All points p with dot(p, normal) == distance.
struct BspPlane {
  math::Vec3 normal{0.0f};
  float distance = 0;
  std::int32_t type = 0;  // 0-2: axial (x, y, z); 3-5: axis of the largest component
  bool operator==(const BspPlane&) const = default;
};

// A texture. Its name selects effects such as liquid and animation.
struct BspMiptex {
  bool present = false;  // false: no data (offset -1); all other fields are empty
  std::string name;      // as stored, at most 15 characters
  std::uint32_t width = 0, height = 0;
  // Mip level k is (width>>k) x (height>>k) palette indices; empty if the level does not contain them.
  std::array<std::vector<std::uint8_t>, 4> mips;
  // Colors of its own instead of the game's palette, at most 256; only version 30 has them.
  std::vector<Rgb> palette{};
  bool operator==(const BspMiptex&) const = default;
};

// A node of the tree of hull 0.
struct BspNode {
  std::uint32_t plane = 0;
  std::array<std::int32_t, 2> children{};  // front, back; negative: leaf -(child + 1)
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::uint32_t first_face = 0, face_count = 0;
  bool operator==(const BspNode&) const = default;
};

// How a texture lies on faces: s = dot(position, s_axis) + s_offset, in texels, and t in the same way.
struct BspTexinfo {
  math::Vec3 s_axis{0.0f};
  float s_offset = 0;
  math::Vec3 t_axis{0.0f};
  float t_offset = 0;
  std::int32_t miptex = 0;
  std::int32_t flags = 0;  // 1: no light map, unlimited size
  bool operator==(const BspTexinfo&) const = default;
};

// A convex polygon, whose vertices run clockwise seen from its front.
struct BspFace {
  std::uint32_t plane = 0;
  std::int32_t side = 0;  // 1: the face points against the plane's normal
  std::uint32_t first_surfedge = 0, surfedge_count = 0;
  std::uint32_t texinfo = 0;
  std::array<std::uint8_t, 4> styles{255, 255, 255, 255};  // 255: unused
  std::int32_t light_offset = -1;                          // into `lighting`; -1: none
  bool operator==(const BspFace&) const = default;
};

// A node of the trees of hulls 1 to 3.
struct BspClipnode {
  std::uint32_t plane = 0;
  std::array<std::int32_t, 2> children{};  // negative: contents
  bool operator==(const BspClipnode&) const = default;
};

// A convex part of space. Leaf 0 is the solid outside that all solid space shares.
struct BspLeaf {
  std::int32_t contents = 0;            // world::Contents
  std::int32_t visibility_offset = -1;  // -1: sees everything
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::uint32_t first_marksurface = 0, marksurface_count = 0;
  std::array<std::uint8_t, 4> ambient{};  // water, sky, slime, lava
  bool operator==(const BspLeaf&) const = default;
};

// A side that two faces share. Edge 0 is unused, because surfedges need a sign.
struct BspEdge {
  std::array<std::uint32_t, 2> vertices{};
  bool operator==(const BspEdge&) const = default;
};

// A brush model: the world, or a door and the like, with its own trees and faces.
struct BspModel {
  math::Vec3 mins{0.0f}, maxs{0.0f}, origin{0.0f};
  // Roots of the trees. Hull 0: a node, or a leaf if negative; hulls 1-3: a clipnode, or contents if
  // negative.
  std::array<std::int32_t, 4> head_nodes{};
  std::int32_t visible_leaves = 0;  // without leaf 0
  std::uint32_t first_face = 0, face_count = 0;
  bool operator==(const BspModel&) const = default;
};

// A lump of the BSPX extension, such as RGBLIGHTING, uninterpreted.
struct BspxLump {
  std::string name;
  base::ByteVector data;
  bool operator==(const BspxLump&) const = default;
};

// A whole level.
struct Bsp {
  BspVersion version = BspVersion::k29;
  std::string entities;
  std::vector<BspPlane> planes;
  std::vector<BspMiptex> miptexes;
  std::vector<math::Vec3> vertices;
  std::vector<std::uint8_t> visibility;  // run-length encoded PVS rows (world/visibility.h)
  std::vector<BspNode> nodes;
  std::vector<BspTexinfo> texinfos;
  std::vector<BspFace> faces;
  std::vector<std::uint8_t> lighting;  // gray samples
  std::vector<BspClipnode> clipnodes;
  std::vector<BspLeaf> leaves;
  std::vector<std::uint32_t> marksurfaces;  // faces by leaf
  std::vector<BspEdge> edges;
  std::vector<std::int32_t> surfedges;  // negative: edge -value, traversed backward
  std::vector<BspModel> models;
  std::vector<BspxLump> bspx;
  // Damage that read_bsp() has repaired, in a sentence that names the first damaged record; empty: none. It
  // is not part of the file.
  std::string repairs;

  // Returns the first BSPX lump with this name, or null.
  const BspxLump* find_bspx(std::string_view name) const;
  bool operator==(const Bsp&) const = default;
};

// Reads any version and validates everything: indices, ranges, finite numbers, closed face
// loops, trees without cycles. bsp_validate.h lists the guarantees. Errors name the lump, the record with its
// offset in the file, and the reason. Memory is limited to a small multiple of the file size, whatever the
// file contains.
//
// Normalizes on the way, without loss: the entity text ends at its first zero; in a level without visibility,
// every leaf's offset becomes -1; in a level without clipnodes, hulls 1-3 become empty contents; a plane of
// type 0-2 whose normal is not that axis, or of an unknown type, gets the right one; bounds are clamped to
// +-kBspMaxCoordinate; texture
// names are truncated to 15 characters; bytes after the last lump that are not BSPX are ignored. Replaces
// what a game does not need: records that it never reaches (bsp/unused.h), damaged textures (bsp/textures.h),
// and damaged BSPX lumps. Repairs what other engines ignore (bsp/repair.h, bsp/lumps.h), and notes that in
// `repairs`.
base::Result<Bsp> read_bsp(base::Bytes bytes);

// Writes a level as `version`, without validation. Version 30 has no gray samples: it gets the colors of the
// BSPX lump RGBLIGHTING, or the gray ones without it. The other versions have no palettes of textures.
// Returns kTooLarge with lump, record, and field if a number does not fit, such as a vertex index over 65535
// in version 29. Bounds of nodes and leaves are integers in 29 and 2PSB: mins are rounded down, maxs up.
// Except for that rounding, a level from read_bsp() reads back equal. The entity text must not contain a zero
// byte.
base::Result<base::ByteVector> write_bsp(const Bsp& bsp, BspVersion version);

}  // namespace temblor::formats
