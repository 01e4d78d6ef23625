// The contents of places in the level made in code, computed only from its list of boxes.
#pragma once

#include <cstdint>
#include <span>

#include "artgen/small_level.h"
#include "math/vec.h"

namespace temblor::test {

constexpr std::int32_t kSolidContents = -2;
constexpr std::int32_t kSkyContents = -6;

// Returns the contents of the last box that contains the point; solid if there is none. The point must not be
// on the side of a box.
std::int32_t find_contents(std::span<const artgen::SmallLevelBox> boxes, const math::Vec3& point);

// Returns whether the inside of the box touches anything solid, or sky, which stops boxes too.
bool stops_box(std::span<const artgen::SmallLevelBox> boxes, const math::Bounds& box);

}  // namespace temblor::test
