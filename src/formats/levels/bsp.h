// Quake levels: version 29, 2PSB and BSP2, one struct for all three (the widest type of each field).
// Layouts: bsp/records.h; see write_bsp for what each version can hold.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

enum class BspVersion { k29, k2Psb, kBsp2 };
const char* name_of(BspVersion version);  // "29", "2PSB", "BSP2"

// The lumps, in the order of the file's directory.
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
const char* name_of(BspLump lump);         // "entities", "planes", ...
const char* record_name_of(BspLump lump);  // of one of its records: "plane", "texture", ...

struct BspPlane {
  math::Vec3 normal{0.0f};
  float distance = 0;
  std::int32_t type = 0;  // 0-2 axial, 3-5 the dominant axis
  bool operator==(const BspPlane&) const = default;
};

struct BspMiptex {
  bool present = false;  // false: the level names no data here (offset -1); all else is empty
  std::string name;      // as stored, at most 15 characters
  std::uint32_t width = 0, height = 0;
  // Mip level k is (width>>k) x (height>>k) palette indices; empty when the texture lies outside the level.
  std::array<std::vector<std::uint8_t>, 4> mips;
  bool operator==(const BspMiptex&) const = default;
};

struct BspNode {
  std::uint32_t plane = 0;
  std::array<std::int32_t, 2> children{};  // front, back; negative: leaf -(child + 1)
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::uint32_t first_face = 0, face_count = 0;
  bool operator==(const BspNode&) const = default;
};

struct BspTexinfo {
  math::Vec3 s_axis{0.0f};
  float s_offset = 0;
  math::Vec3 t_axis{0.0f};
  float t_offset = 0;
  std::int32_t miptex = 0;
  std::int32_t flags = 0;  // 1: no light map, any extent
  bool operator==(const BspTexinfo&) const = default;
};

struct BspFace {
  std::uint32_t plane = 0;
  std::int32_t side = 0;  // 1: the face looks against its plane's normal
  std::uint32_t first_surfedge = 0, surfedge_count = 0;
  std::uint32_t texinfo = 0;
  std::array<std::uint8_t, 4> styles{255, 255, 255, 255};  // 255: unused
  std::int32_t light_offset = -1;                          // into lighting, -1: none
  bool operator==(const BspFace&) const = default;
};

struct BspClipnode {
  std::uint32_t plane = 0;
  std::array<std::int32_t, 2> children{};  // negative: contents
  bool operator==(const BspClipnode&) const = default;
};

struct BspLeaf {
  std::int32_t contents = 0;
  std::int32_t visibility_offset = -1;  // -1: sees everything
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::uint32_t first_marksurface = 0, marksurface_count = 0;
  std::array<std::uint8_t, 4> ambient{};  // water, sky, slime, lava
  bool operator==(const BspLeaf&) const = default;
};

struct BspEdge {
  std::array<std::uint32_t, 2> vertices{};
  bool operator==(const BspEdge&) const = default;
};

struct BspModel {
  math::Vec3 mins{0.0f}, maxs{0.0f}, origin{0.0f};
  std::array<std::int32_t, 4>
      head_nodes{};                 // hull 0: node, or leaf when negative; hulls 1-3: clipnode or contents
  std::int32_t visible_leaves = 0;  // without leaf 0
  std::uint32_t first_face = 0, face_count = 0;
  bool operator==(const BspModel&) const = default;
};

struct BspxLump {
  std::string name;
  base::ByteVector data;
  bool operator==(const BspxLump&) const = default;
};

struct Bsp {
  BspVersion version = BspVersion::k29;
  std::string entities;
  std::vector<BspPlane> planes;
  std::vector<BspMiptex> miptexes;
  std::vector<math::Vec3> vertices;
  std::vector<std::uint8_t> visibility;
  std::vector<BspNode> nodes;
  std::vector<BspTexinfo> texinfos;
  std::vector<BspFace> faces;
  std::vector<std::uint8_t> lighting;  // gray samples
  std::vector<BspClipnode> clipnodes;
  std::vector<BspLeaf> leaves;
  std::vector<std::uint32_t> marksurfaces;
  std::vector<BspEdge> edges;
  std::vector<std::int32_t> surfedges;  // negative: edge -value, end to start
  std::vector<BspModel> models;
  std::vector<BspxLump> bspx;

  const BspxLump* find_bspx(std::string_view name) const;
  bool operator==(const Bsp&) const = default;
};

// Reads any of the three versions and validates it whole: every index and range lies inside its array, trees
// have no cycles, every number is finite, face loops close, model 0 exists and its head node is hull 0's
// root. What a reader of the result may rely on is listed in bsp_validate.h. Errors name lump, record, its
// offset in the file, and reason. Memory stays within a small multiple of the file's size, whatever is in it.
//
// Made regular on the way in, because nothing is lost by it: the entity text ends at its first zero; in a
// level without visibility every leaf's offset becomes -1; in a level without clipnodes hulls 1-3 become
// empty contents; a plane of type 0-2 whose normal is not that axis gets type 3-5; bounds beyond
// +-kBspMaxCoordinate are cut to it; a texture's name is cut to 15 characters; bytes after the last lump that
// are not BSPX are ignored.
base::Result<Bsp> read_bsp(base::Bytes bytes);

// Writes as `version`; kTooLarge, naming lump, record and field, when a number does not fit that version (a
// vertex index over 65535 in 29, ...). Node and leaf bounds are whole numbers in 29 and 2PSB: mins are
// rounded down and maxs up. Nothing is validated: what read_bsp returned reads back equal, but for that
// rounding; the entity text must hold no zero byte.
base::Result<base::ByteVector> write_bsp(const Bsp& bsp, BspVersion version);

}  // namespace temblor::formats
