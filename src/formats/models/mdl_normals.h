// The directions that a model's vertices choose their normals from.
#pragma once

#include <span>

#include "math/vec.h"

namespace temblor::formats {

// kMdlNormals unit vectors, in the order of MdlVertex::normal.
std::span<const math::Vec3> mdl_normals();

}  // namespace temblor::formats
