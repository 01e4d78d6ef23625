// The fixed table of vertex normals of alias models. A model stores only an index for each vertex, so that
// lighting needs no computation of normals. mdl_normals.cpp describes how the table was found.
#pragma once

#include <span>

#include "math/vec.h"

namespace temblor::formats {

// Returns kMdlNormals unit vectors, by MdlVertex::normal. Valid until the program ends. Thread-safe.
std::span<const math::Vec3> mdl_normals();

}  // namespace temblor::formats
