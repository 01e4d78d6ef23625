// BSPX FACENORMALS: the directions of smooth surfaces at the corners of faces, for dynamic lights and bump
// maps.
//
//    0  count u32, and vectors f32[3]
//    .  for each face, for each of its surfedges: normal u32, tangent u32, bitangent u32: numbers of vectors
//
// Layout: the documentation of ericw-tools, "BSPX Lumps".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::formats {

inline constexpr const char* kFaceNormalsLump = "FACENORMALS";

// Numbers of vectors.
struct CornerVectors {
  std::uint32_t normal = 0, tangent = 0, bitangent = 0;
  bool operator==(const CornerVectors&) const = default;
};

struct FaceNormals {
  std::vector<math::Vec3> vectors;
  std::vector<CornerVectors> corners;  // face by face, in the order of its surfedges
  bool operator==(const FaceNormals&) const = default;
};

// Returns nothing in both lists if the level has no such lump. Fails if it is not as large as the faces need,
// or if a number of a vector is out of range.
base::Result<FaceNormals> read_face_normals(const Bsp& bsp);

// Replaces the level's lump.
void set_face_normals(const FaceNormals& normals, Bsp& io_bsp);

}  // namespace temblor::formats
