#include "movement/player/velocity.h"

#include <algorithm>
#include <cmath>

#include "math/angles.h"

namespace temblor::movement {
namespace {

constexpr float kProbeAhead = 16, kProbeDepth = 34;  // units
constexpr float kAirSpeed = 30;
constexpr float kSwimSpeed = 0.7f;                     // share of the walking speed
constexpr float kSinkSpeed = 60;                       // without a wish
constexpr float kRollAngle_deg = 2, kRollSpeed = 200;  // the full roll is reached at this sideways speed
constexpr float kPunchFade_deg = 10;                   // per second

// Adds velocity toward `direction` until the part along it is `speed`. The acceleration is that of a wish for
// `full_speed`, and the last step is cut short so that it never overshoots.
math::Vec3 accelerate_toward(const math::Vec3& velocity, const math::Vec3& direction, float speed,
                             float full_speed, const math::PhysicsSettings& settings, float tick_s) {
  const float missing = speed - glm::dot(velocity, direction);
  if (missing <= 0) return velocity;
  return velocity + direction * std::min(missing, settings.accelerate * full_speed * tick_s);
}

math::Vec3 unit_or_zero(const math::Vec3& v, float length) {
  return length > 0 ? v / length : math::Vec3(0.0f);
}

}  // namespace

// Below stop_speed, friction is as strong as at it, so that a slow player comes to rest within a few ticks
// instead of slowing down ever more gently.
math::Vec3 apply_ground_friction(const math::Vec3& velocity, const math::PhysicsSettings& settings,
                                 float tick_s, bool is_at_edge) {
  const float speed = glm::length(math::Vec2(velocity));
  if (speed == 0) return velocity;
  const float friction = settings.friction * (is_at_edge ? settings.edge_friction : 1.0f);
  const float new_speed = speed - tick_s * std::max(speed, settings.stop_speed) * friction;
  return velocity * (std::max(new_speed, 0.0f) / speed);
}

EdgeProbe make_edge_probe(const math::Vec3& origin, float mins_z, const math::Vec3& velocity) {
  const float speed = glm::length(math::Vec2(velocity));
  const math::Vec3 start(origin.x + velocity.x / speed * kProbeAhead,
                         origin.y + velocity.y / speed * kProbeAhead, origin.z + mins_z);
  return {start, start - math::Vec3(0, 0, kProbeDepth)};
}

math::Vec3 accelerate_on_ground(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                                const math::PhysicsSettings& settings, float tick_s) {
  const float speed = glm::length(wish_velocity);
  return accelerate_toward(velocity, unit_or_zero(wish_velocity, speed), speed, speed, settings, tick_s);
}

math::Vec3 accelerate_in_air(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                             const math::PhysicsSettings& settings, float tick_s) {
  const float speed = glm::length(wish_velocity);
  return accelerate_toward(velocity, unit_or_zero(wish_velocity, speed), std::min(speed, kAirSpeed), speed,
                           settings, tick_s);
}

// Unlike on the ground, friction here is proportional to the speed at any speed, and acts on z too.
math::Vec3 accelerate_in_water(const math::Vec3& velocity, const math::Vec3& view_angles_deg,
                               const Wish& wish, const math::PhysicsSettings& settings, float tick_s) {
  math::Vec3 wished = find_wish_velocity(view_angles_deg, wish);
  const bool wishes_nothing = wish.forward == 0 && wish.side == 0 && wish.up == 0;
  wished.z += wishes_nothing ? -kSinkSpeed : wish.up;
  wished = limit_speed(wished, settings.max_speed) * kSwimSpeed;

  const float speed = glm::length(velocity);
  const float slower = std::max(speed - tick_s * speed * settings.friction, 0.0f);
  const math::Vec3 slowed = speed > 0 ? velocity * (slower / speed) : velocity;
  const float wished_speed = glm::length(wished);
  // The wish is compared with the speed in any direction, not only along it, so turns are slow in water.
  const float missing = wished_speed - slower;
  if (wished_speed == 0 || missing <= 0) return slowed;
  return slowed + wished / wished_speed * std::min(missing, settings.accelerate * wished_speed * tick_s);
}

math::Vec3 find_wish_velocity(const math::Vec3& angles_deg, const Wish& wish) {
  const math::Basis basis = math::basis_from_angles(angles_deg);
  return math::Vec3(basis.forward * double{wish.forward} + basis.right * double{wish.side});
}

math::Vec3 limit_speed(const math::Vec3& velocity, float max_speed) {
  const float speed = glm::length(velocity);
  return speed > max_speed ? velocity * (max_speed / speed) : velocity;
}

math::Vec3 limit_velocity(math::Vec3 velocity, float max_velocity) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isnan(velocity[axis])) velocity[axis] = 0;
    velocity[axis] = std::max(std::min(velocity[axis], max_velocity), -max_velocity);
  }
  return velocity;
}

float find_roll_deg(const math::Vec3& angles_deg, const math::Vec3& velocity) {
  const math::Basis basis = math::basis_from_angles(angles_deg);
  const auto side = static_cast<float>(glm::dot(math::Vec3d(velocity), basis.right));
  return std::clamp(side / kRollSpeed, -1.0f, 1.0f) * kRollAngle_deg;
}

math::Vec3 fade_punch(const math::Vec3& punch_deg, float tick_s) {
  const float length = glm::length(punch_deg);
  return unit_or_zero(punch_deg, length) * std::max(length - kPunchFade_deg * tick_s, 0.0f);
}

}  // namespace temblor::movement
