// Computes the effect of a player's input on its velocity in one tick: on the ground, in the air, and in
// water. The formulas are those of the original game, from its observed behavior. Friction is applied first,
// then the velocity along the wish grows up to the wished speed. The part of the velocity that is
// perpendicular to the wish is kept, which is why turning in the air gains speed. All velocities are in units
// per second; `tick_s` is the length of the tick in seconds.
#pragma once

#include "math/physics_settings.h"
#include "math/vec.h"

namespace temblor::movement {

// A player's input in units per second, along the axes of its view.
struct Wish {
  float forward = 0, side = 0, up = 0;
};

// --- On the ground.

// Slows a walking player down. `is_at_edge`: there is no floor just ahead of it (see make_edge_probe()), and
// friction is multiplied by edge_friction.
math::Vec3 apply_ground_friction(const math::Vec3& velocity, const math::PhysicsSettings& settings,
                                 float tick_s, bool is_at_edge);
// A line 16 units ahead of a body's feet, from their height downward. If nothing stops it, the body is at an
// edge.
struct EdgeProbe {
  math::Vec3 start, end;
};
// `velocity` must not be 0 along both x and y. `mins_z`: the lower side of the body's box.
EdgeProbe make_edge_probe(const math::Vec3& origin, float mins_z, const math::Vec3& velocity);
// Adds a tick's acceleration toward the wish.
math::Vec3 accelerate_on_ground(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                                const math::PhysicsSettings& settings, float tick_s);

// --- In the air and in water.

// Reaches only 30 units per second along the wish, but as quickly as if it were all of the wished speed.
math::Vec3 accelerate_in_air(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                             const math::PhysicsSettings& settings, float tick_s);
// Applies friction in all directions, and acceleration toward the wish. A player without a wish sinks.
math::Vec3 accelerate_in_water(const math::Vec3& velocity, const math::Vec3& view_angles_deg,
                               const Wish& wish, const math::PhysicsSettings& settings, float tick_s);

// --- Helpers.

// The velocity that a player asks for if it looks along these angles, without its `up`. Not limited.
math::Vec3 find_wish_velocity(const math::Vec3& angles_deg, const Wish& wish);
// Keeps the direction, and reduces the length to at most `max_speed`.
math::Vec3 limit_speed(const math::Vec3& velocity, float max_speed);
// Limits each axis separately to +-max_velocity, and replaces NaN by 0.
math::Vec3 limit_velocity(math::Vec3 velocity, float max_velocity);

// The angle by which a body leans toward the side that it moves to, at most 2 degrees.
float find_roll_deg(const math::Vec3& angles_deg, const math::Vec3& velocity);
// Reduces a punch of the view by 10 degrees per second.
math::Vec3 fade_punch(const math::Vec3& punch_deg, float tick_s);

}  // namespace temblor::movement
