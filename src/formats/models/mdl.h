// Alias models (.mdl), version 6: a triangle mesh with skins, and the positions of all vertices for every
// frame. There is no skeleton; the renderer may blend two poses.
//
//   header, 84 bytes       0  "IDPO"
//                          4  version i32 (6)
//                          8  scale f32 x3             position = scale * byte + origin, on each axis
//                         20  origin f32 x3
//                         32  bounding radius f32
//                         36  eye f32 x3
//                         48  number of skins i32
//                         52  skin width i32, skin height i32
//                         60  number of vertices i32, of triangles i32, of frames i32
//                         72  random phase i32         1: entities start animated groups at different times
//                         76  flags i32                MdlFlags
//                         80  average triangle size f32
//   skins                 single or group (model_bytes.h) of width x height palette indices
//   texture coordinates   for each vertex: on seam i32 (0 or 32) | s i32 | t i32
//   triangles             faces front i32 | vertex i32 x3
//   frames                single or group of poses:
//                         mins u8 x4 | maxs u8 x4 | name char[16] | vertices
//   vertex, 4 bytes       position u8 x3 | normal u8
//
// A skin shows the front of the model on its left half and the back on its right half. Vertices on the seam
// between them have two places: s, and s + half of the width for triangles that face the back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// Limits of a file, far above those of stock games and mods.
constexpr std::uint32_t kMaxMdlVertices = 1 << 16, kMaxMdlTriangles = 1 << 17, kMaxMdlPoses = 1 << 14,
                        kMaxMdlSkins = 1 << 14;
constexpr std::uint32_t kMaxMdlSkinSide = 1 << 13;  // texels
// Limit of texture coordinates in either direction, in texels.
constexpr std::int32_t kMaxMdlTexel = 1 << 16;
constexpr std::size_t kMdlNormals = 162;
// Limit of |scale| * 255 + |origin| on each axis, in units.
constexpr float kMaxMdlCoordinate = 1 << 20;

// Effects of every entity with this model: trails of particles, and rotation.
enum MdlFlags : std::uint32_t {
  kMdlRocketTrail = 1,
  kMdlGrenadeSmoke = 2,
  kMdlGibBlood = 4,
  kMdlRotate = 8,
  kMdlTracer = 16,
  kMdlZombieBlood = 32,
  kMdlTracer2 = 64,
  kMdlTracer3 = 128
};

// Position: scale * bytes + origin on each axis. `normal`: index of one of kMdlNormals directions
// (mdl_normals.h).
struct MdlVertex {
  std::array<std::uint8_t, 3> position{};
  std::uint8_t normal = 0;
  bool operator==(const MdlVertex&) const = default;
};

// Texture coordinates of a vertex in texels; may be outside of the skin, by at most kMaxMdlTexel. In
// triangles that face the back, vertices on the seam use s + half of the skin's width.
struct MdlTexel {
  bool on_seam = false;
  std::int32_t s = 0, t = 0;
  bool operator==(const MdlTexel&) const = default;
};

struct MdlTriangle {
  bool faces_front = true;
  std::array<std::uint32_t, 3> vertices{};  // clockwise seen from outside
  bool operator==(const MdlTriangle&) const = default;
};

// The positions and normals of all vertices at one moment.
struct MdlPose {
  MdlVertex mins, maxs;  // of its vertices, as bytes
  std::string name;      // such as "run1"; at most 15 characters
  std::vector<MdlVertex> vertices;
  bool operator==(const MdlPose&) const = default;
};

// A frame: one pose, or a group of poses that play as an animation. end_times_s holds the time in seconds at
// which each pose of a group ends, strictly increasing.
struct MdlFrame {
  std::vector<MdlPose> poses;      // at least one
  std::vector<float> end_times_s;  // empty: not a group
  MdlVertex mins, maxs;            // of the group
  bool operator==(const MdlFrame&) const = default;
};

// A skin: one picture, or an animated group. Each has skin_width x skin_height palette indices, row by row.
struct MdlSkin {
  std::vector<std::vector<std::uint8_t>> pictures;  // at least one
  std::vector<float> end_times_s;                   // empty: not a group
  bool operator==(const MdlSkin&) const = default;
};

// A whole model.
struct Mdl {
  math::Vec3 scale{1.0f}, origin{0.0f};
  float bounding_radius = 0;
  math::Vec3 eye{0.0f};
  std::uint32_t skin_width = 0, skin_height = 0;
  std::vector<MdlSkin> skins;    // at least one
  std::vector<MdlTexel> texels;  // by vertex
  std::vector<MdlTriangle> triangles;
  std::vector<MdlFrame> frames;  // at least one; every pose has texels.size() vertices
  bool random_phase = false;     // every entity starts its groups at a different time
  std::uint32_t flags = 0;       // MdlFlags
  float average_triangle_size = 0;
  bool operator==(const Mdl&) const = default;
};

// Reads and validates a model: all indices are in range, and all numbers finite. Errors name the part and its
// offset.
base::Result<Mdl> read_mdl(base::Bytes bytes);
// Writes a model. CHECKs the same rules. The result reads back as an equal model.
base::ByteVector write_mdl(const Mdl& mdl);

}  // namespace temblor::formats
