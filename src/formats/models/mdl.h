// Alias models (.mdl): a triangle mesh with skins, and a full set of vertices for every frame.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// What a file may hold; far above what stock games and mods use.
constexpr std::uint32_t kMaxMdlVertices = 1 << 16, kMaxMdlTriangles = 1 << 17, kMaxMdlPoses = 1 << 14,
                        kMaxMdlSkins = 1 << 14;
constexpr std::uint32_t kMaxMdlSkinSide = 1 << 13;  // texels
constexpr std::int32_t kMaxMdlTexel = 1 << 16;
constexpr std::size_t kMdlNormals = 162;
// Of a vertex, in units along an axis: |scale| * 255 + |origin| at most.
constexpr float kMaxMdlCoordinate = 1 << 20;

// Effects that a model asks for wherever it is used.
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

// Position: scale * bytes + origin, along each axis. `normal` is one of kMdlNormals directions
// (mdl_normals.h).
struct MdlVertex {
  std::array<std::uint8_t, 3> position{};
  std::uint8_t normal = 0;
  bool operator==(const MdlVertex&) const = default;
};

// Where a vertex lies on the skin, in texels; within kMaxMdlTexel of the skin's corner, but not always on the
// skin. On a triangle that faces the back, vertices on the seam lie
// half a skin's width further right.
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

// One set of vertices.
struct MdlPose {
  MdlVertex mins, maxs;
  std::string name;  // at most 15 characters
  std::vector<MdlVertex> vertices;
  bool operator==(const MdlPose&) const = default;
};

// What a frame number stands for: one pose, or several that follow one another by themselves. A group has the
// time at which each of its poses ends, rising, in seconds; a single pose (poses.size() == 1) may have none.
struct MdlFrame {
  std::vector<MdlPose> poses;      // at least one
  std::vector<float> end_times_s;  // empty: not a group
  MdlVertex mins, maxs;            // of a group
  bool operator==(const MdlFrame&) const = default;
};

// The same for skins: skin_width x skin_height palette indices each, row by row.
struct MdlSkin {
  std::vector<std::vector<std::uint8_t>> pictures;  // at least one
  std::vector<float> end_times_s;                   // empty: not a group
  bool operator==(const MdlSkin&) const = default;
};

struct Mdl {
  math::Vec3 scale{1.0f}, origin{0.0f};
  float bounding_radius = 0;
  math::Vec3 eye{0.0f};
  std::uint32_t skin_width = 0, skin_height = 0;
  std::vector<MdlSkin> skins;    // at least one
  std::vector<MdlTexel> texels;  // by vertex
  std::vector<MdlTriangle> triangles;
  std::vector<MdlFrame> frames;  // at least one; every pose has texels.size() vertices
  bool random_phase = false;     // groups start at a time of their own for each entity
  std::uint32_t flags = 0;       // MdlFlags
  float average_triangle_size = 0;
  bool operator==(const Mdl&) const = default;
};

// Every index is in range and every number finite in what is returned. Errors name the part and its offset.
base::Result<Mdl> read_mdl(base::Bytes bytes);
// CHECKs the rules above. Reads back as the same model.
base::ByteVector write_mdl(const Mdl& mdl);

}  // namespace temblor::formats
