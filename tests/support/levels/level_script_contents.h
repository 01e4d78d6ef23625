// What is where in the level made in code, told from its list of boxes and nothing else.
#pragma once

#include <cstdint>
#include <span>

#include "artgen/small_level.h"
#include "math/vec.h"

namespace temblor::test {

constexpr std::int32_t kPlanSolid = -2;
constexpr std::int32_t kPlanSky = -6;

// The contents of the last box that holds the point; solid where none does. The point lies on no box's side.
std::int32_t plan_contents(std::span<const artgen::SmallLevelBox> boxes, const math::Vec3& point);

// Whether the inside of the box meets anything solid, or sky, which stops boxes as well.
bool plan_stops_box(std::span<const artgen::SmallLevelBox> boxes, const math::Bounds& box);

}  // namespace temblor::test
