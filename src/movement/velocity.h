// What players' wishes do to their velocity in one tick: on the ground, in the air, in water.
#pragma once

#include "math/vec.h"
#include "movement/settings.h"

namespace temblor::movement {

// What a player asks for; units a second.
struct Wish {
  float forward = 0, side = 0, up = 0;
};

// In air and in water `tick_s` of acceleration towards the wish; all velocities in units a second.
//
// Friction of walking; `is_at_edge`: no floor just ahead (see edge_probe).
math::Vec3 slowed_on_ground(const math::Vec3& velocity, const Settings& settings, float tick_s,
                            bool is_at_edge);
// Where to look for a floor ahead of a body with these feet: nothing between the two is an edge. Only for
// bodies that move along x or y.
struct EdgeProbe {
  math::Vec3 start, end;
};
EdgeProbe edge_probe(const math::Vec3& origin, float mins_z, const math::Vec3& velocity);

math::Vec3 accelerated_on_ground(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                                 const Settings& settings, float tick_s);
// Only up to 30 units a second along the wish, but as hard as for all of it.
math::Vec3 accelerated_in_air(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                              const Settings& settings, float tick_s);
// With friction in all directions; whoever wishes nothing sinks.
math::Vec3 swum(const math::Vec3& velocity, const math::Vec3& view_angles_deg, const Wish& wish,
                const Settings& settings, float tick_s);

// Where someone who looks there wishes to go on foot; not capped.
math::Vec3 wish_velocity(const math::Vec3& angles_deg, const Wish& wish);
// The same direction, no faster.
math::Vec3 capped(const math::Vec3& velocity, float max_speed);

// No faster along any axis; what is no number is 0.
math::Vec3 bounded(math::Vec3 velocity, float max_velocity);

// How far a body leans to the side that it moves to.
float roll_deg(const math::Vec3& angles_deg, const math::Vec3& velocity);
// Fades by 10 degrees a second.
math::Vec3 faded_punch(const math::Vec3& punch_deg, float tick_s);

}  // namespace temblor::movement
