// MD3 models, version 15 (id Tech 3; mods of today use them): meshes with the positions of all vertices for
// every frame. Skins are files of their own.
//
//   header, 108 bytes     0  "IDP3"
//                         4  version i32 (15)
//                         8  name char[64]
//                        72  flags i32                 MdlFlags
//                        76  number of frames i32, of tags i32, of surfaces i32, of skins i32
//                        92  offset of frames i32, of tags i32, of surfaces i32, of the end i32
//   frame, 56 bytes       0  mins f32 x3, maxs f32 x3, origin f32 x3, radius f32
//                        40  name char[16]
//   surface, 108 bytes    0  "IDP3"
//                         4  name char[64]
//                        68  flags i32
//                        72  number of frames i32, of shaders i32, of vertices i32, of triangles i32
//                        88  offset of triangles i32, of shaders i32, of texels i32, of vertices i32,
//                            of the next surface i32   all from the start of the surface
//   shader, 68 bytes      name char[64] | number i32
//   triangle              vertex i32 x3                clockwise seen from outside
//   texel                 s f32, t f32                 0 to 1 across the skin, from its upper left corner
//   vertex, 8 bytes       position i16 x3, in 1/64 unit | zenith u8 | azimuth u8
//
// A normal has angles in 1/256 of a turn: from the z axis, and around it. Tags, places that game code of
// Quake III attaches models to, are skipped.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// Limits of a file, above those of Quake III.
constexpr std::uint32_t kMaxMd3Frames = 1 << 12, kMaxMd3Surfaces = 1 << 6, kMaxMd3Shaders = 1 << 8,
                        kMaxMd3Vertices = 1 << 16, kMaxMd3Triangles = 1 << 17;
constexpr float kMd3Units = 1.0f / 64;   // of positions
constexpr float kMaxMd3Texel = 1 << 10;  // either sign
// Limit of the vertices of all surfaces in all frames, because surfaces of a file may overlap.
constexpr std::size_t kMaxMd3PosedVertices = std::size_t{1} << 23;

struct Md3Frame {
  std::string name;
  math::Bounds bounds;  // as the file has it; finite
};

struct Md3Vertex {
  std::array<std::int16_t, 3> position{};  // in kMd3Units
  std::uint8_t zenith = 0, azimuth = 0;    // of the normal
  bool operator==(const Md3Vertex&) const = default;
};

// The triangles that share a skin. All indices are in range.
struct Md3Surface {
  std::string name;
  std::vector<std::string> shaders;  // names the skins; may be empty
  std::vector<math::Vec2> texels;    // by vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Md3Vertex> vertices;  // frame by frame, each texels.size()
};

struct Md3 {
  std::uint32_t flags = 0;           // MdlFlags
  std::vector<Md3Frame> frames;      // at least one
  std::vector<Md3Surface> surfaces;  // at least one
};

// Reads and validates a model. Errors name the part and its offset.
base::Result<Md3> read_md3(base::Bytes bytes);

}  // namespace temblor::formats
