// The fixed table of vertex normals of alias models. A model stores only an index for each vertex, so that
// lighting needs no computation of normals. mdl_normals.cpp describes how the table was found.
#pragma once

#include <cstdint>
#include <span>

#include "math/vec.h"

namespace temblor::formats {

// Returns kMdlNormals unit vectors, by MdlVertex::normal. Valid until the program ends. Thread-safe.
std::span<const math::Vec3> mdl_normals();

// Returns the index of the normal that is nearest to `direction`, which may have any length. Thread-safe.
std::uint8_t find_nearest_normal(const math::Vec3& direction);

}  // namespace temblor::formats
