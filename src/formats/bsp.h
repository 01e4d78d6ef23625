// Quake levels: version 29, 2PSB and BSP2, one struct for all three (the widest type of each field).
// Layouts: docs and the data; see write_bsp for what each version can hold.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

enum class BspVersion { k29, k2Psb, kBsp2 };
const char* name_of(BspVersion version);  // "29", "2PSB", "BSP2"

struct BspPlane {
  math::Vec3 normal{0.0f};
  float distance = 0;
  std::int32_t type = 0;  // 0-2 axial, 3-5 the dominant axis
};

struct BspMiptex {
  bool present = false;  // false: the level names no data here (offset -1); all else is empty
  std::string name;      // as stored, at most 15 characters
  std::uint32_t width = 0, height = 0;
  // Mip level k is (width>>k) x (height>>k) palette indices; empty when the texture lies outside the level.
  std::array<std::vector<std::uint8_t>, 4> mips;
};

struct BspNode {
  std::uint32_t plane = 0;
  std::array<std::int32_t, 2> children{};  // front, back; negative: leaf -(child + 1)
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::uint32_t first_face = 0, face_count = 0;
};

struct BspTexinfo {
  math::Vec3 s_axis{0.0f};
  float s_offset = 0;
  math::Vec3 t_axis{0.0f};
  float t_offset = 0;
  std::int32_t miptex = 0;
  std::int32_t flags = 0;  // 1: no light map, any extent
};

struct BspFace {
  std::uint32_t plane = 0;
  std::int32_t side = 0;  // 1: the face looks against its plane's normal
  std::uint32_t first_surfedge = 0, surfedge_count = 0;
  std::uint32_t texinfo = 0;
  std::array<std::uint8_t, 4> styles{255, 255, 255, 255};  // 255: unused
  std::int32_t light_offset = -1;                          // into lighting, -1: none
};

struct BspClipnode {
  std::uint32_t plane = 0;
  std::array<std::int32_t, 2> children{};  // negative: contents
};

struct BspLeaf {
  std::int32_t contents = 0;
  std::int32_t visibility_offset = -1;  // -1: sees everything
  math::Vec3 mins{0.0f}, maxs{0.0f};
  std::uint32_t first_marksurface = 0, marksurface_count = 0;
  std::array<std::uint8_t, 4> ambient{};  // water, sky, slime, lava
};

struct BspEdge {
  std::array<std::uint32_t, 2> vertices{};
};

struct BspModel {
  math::Vec3 mins{0.0f}, maxs{0.0f}, origin{0.0f};
  std::array<std::int32_t, 4>
      head_nodes{};                // hull 0: node, or leaf when negative; hulls 1-3: clipnode or contents
  std::int32_t visible_leafs = 0;  // without leaf 0
  std::uint32_t first_face = 0, face_count = 0;
};

struct BspxLump {
  std::string name;
  base::ByteVector data;
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
  std::vector<std::uint8_t> lighting;  // grey samples
  std::vector<BspClipnode> clipnodes;
  std::vector<BspLeaf> leafs;
  std::vector<std::uint32_t> marksurfaces;
  std::vector<BspEdge> edges;
  std::vector<std::int32_t> surfedges;  // negative: edge -value, end to start
  std::vector<BspModel> models;
  std::vector<BspxLump> bspx;

  const BspxLump* find_bspx(std::string_view name) const;
};

// Reads any of the three versions and validates it whole: every index and range lies inside its array, trees
// have no cycles, every number is finite, face loops close, model 0 exists and its head node is hull 0's
// root. What a reader of the result may rely on is listed in bsp_validate.h. Errors name lump, record and
// reason.
base::Result<Bsp> read_bsp(base::Bytes bytes);

// Writes as `version`; fails when a number does not fit that version (more than 65535 edges' vertices in 29,
// ...).
base::Result<base::ByteVector> write_bsp(const Bsp& bsp, BspVersion version);

}  // namespace temblor::formats
