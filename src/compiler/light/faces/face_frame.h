// The space of a face: the directions of its texture, and its normal.
#pragma once

#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

// Unit vectors. Tangent and bitangent are perpendicular to the normal, but not always to each other.
struct FaceFrame {
  math::Vec3d tangent, bitangent, normal;
};

// The frame at a place of a face with this unit normal, which may differ from the plane's on a curved face.
FaceFrame make_face_frame(const world::TextureAxes& axes, const math::Vec3d& normal);

}  // namespace temblor::compiler
