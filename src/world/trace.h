// Traces: how far a point or a box gets along a line before it meets something solid.
#pragma once

#include "world/level.h"

namespace temblor::world {

// Hull 0 is for points; hulls 1 and 2 are clip trees grown by the player's and a large monster's box at
// compile time.
enum class Hull : std::uint8_t { kPoint, kPlayer, kLarge };

// The smallest hull that holds a box of that size (by its width in x: under 3, up to 32, more); the offset to
// add to positions so that the hull's own mins meet the box's.
struct HullChoice {
  Hull hull;
  math::Vec3 offset;
};
HullChoice choose_hull(const math::Vec3& box_mins, const math::Vec3& box_maxs);

struct Trace {
  bool all_solid = false;                  // the whole path is inside solid; then fraction is 1
  bool start_solid = false;                // the start is inside solid
  bool in_open = false, in_water = false;  // part of the path is empty; is a liquid, sky or current
  float fraction = 1;                      // of the path that is free, 1: all of it
  math::Vec3 end{0.0f};
  math::Vec3 plane_normal{0.0f};  // of what stopped it, when fraction < 1
  float plane_distance = 0;
};

// From start to end through one model's hull, in that model's space. Stops 1/32 unit short of the surface,
// measured along its normal. A path that starts in solid ends where it comes back into solid.
Trace trace_line(const Level& level, ModelIndex model, Hull hull, const math::Vec3& start,
                 const math::Vec3& end);

// A box through one of the level's models that stands at `model_origin`; all of it, and `end` of the result,
// in the world. Of the hulls the one that choose_hull() says.
Trace trace_box_through(const Level& level, ModelIndex model, const math::Vec3& model_origin,
                        const math::Bounds& box, const math::Vec3& start, const math::Vec3& end);

Contents hull_contents(const Level& level, ModelIndex model, Hull hull, const math::Vec3& point);

}  // namespace temblor::world
