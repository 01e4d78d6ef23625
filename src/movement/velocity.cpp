#include "movement/velocity.h"

#include <algorithm>
#include <cmath>

#include "math/angles.h"

namespace temblor::movement {
namespace {

constexpr float kProbeAhead = 16, kProbeDepth = 34;
constexpr float kAirSpeed = 30;
constexpr float kSwimSpeed = 0.7f, kSinkSpeed = 60;
constexpr float kRollAngle_deg = 2, kRollSpeed = 200;
constexpr float kPunchFade_deg = 10;

// Towards `direction`, until the velocity along it is `speed`; as hard as a wish for `full_speed` asks.
math::Vec3 accelerated(const math::Vec3& velocity, const math::Vec3& direction, float speed, float full_speed,
                       const Settings& settings, float tick_s) {
  const float missing = speed - glm::dot(velocity, direction);
  if (missing <= 0) return velocity;
  return velocity + direction * std::min(missing, settings.accelerate * full_speed * tick_s);
}

math::Vec3 direction_of(const math::Vec3& v, float length) {
  return length > 0 ? v / length : math::Vec3(0.0f);
}

}  // namespace

math::Vec3 slowed_on_ground(const math::Vec3& velocity, const Settings& settings, float tick_s,
                            bool is_at_edge) {
  const float speed = glm::length(math::Vec2(velocity));
  if (speed == 0) return velocity;
  const float friction = settings.friction * (is_at_edge ? settings.edge_friction : 1.0f);
  const float new_speed = speed - tick_s * std::max(speed, settings.stop_speed) * friction;
  return velocity * (std::max(new_speed, 0.0f) / speed);
}

EdgeProbe edge_probe(const math::Vec3& origin, float mins_z, const math::Vec3& velocity) {
  const float speed = glm::length(math::Vec2(velocity));
  const math::Vec3 start(origin.x + velocity.x / speed * kProbeAhead,
                         origin.y + velocity.y / speed * kProbeAhead, origin.z + mins_z);
  return {start, start - math::Vec3(0, 0, kProbeDepth)};
}

math::Vec3 accelerated_on_ground(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                                 const Settings& settings, float tick_s) {
  const float speed = glm::length(wish_velocity);
  return accelerated(velocity, direction_of(wish_velocity, speed), speed, speed, settings, tick_s);
}

math::Vec3 accelerated_in_air(const math::Vec3& velocity, const math::Vec3& wish_velocity,
                              const Settings& settings, float tick_s) {
  const float speed = glm::length(wish_velocity);
  return accelerated(velocity, direction_of(wish_velocity, speed), std::min(speed, kAirSpeed), speed,
                     settings, tick_s);
}

math::Vec3 swum(const math::Vec3& velocity, const math::Vec3& view_angles_deg, const Wish& wish,
                const Settings& settings, float tick_s) {
  math::Vec3 wished = wish_velocity(view_angles_deg, wish);
  const bool wishes_nothing = wish.forward == 0 && wish.side == 0 && wish.up == 0;
  wished.z += wishes_nothing ? -kSinkSpeed : wish.up;
  wished = capped(wished, settings.max_speed) * kSwimSpeed;

  const float speed = glm::length(velocity);
  const float slower = std::max(speed - tick_s * speed * settings.friction, 0.0f);
  const math::Vec3 slowed = speed > 0 ? velocity * (slower / speed) : velocity;
  const float wished_speed = glm::length(wished);
  // Compared with the speed in any direction, not only that of the wish: turns are slow in water.
  const float missing = wished_speed - slower;
  if (wished_speed == 0 || missing <= 0) return slowed;
  return slowed + wished / wished_speed * std::min(missing, settings.accelerate * wished_speed * tick_s);
}

math::Vec3 wish_velocity(const math::Vec3& angles_deg, const Wish& wish) {
  const math::Basis basis = math::basis_from_angles(angles_deg);
  return math::Vec3(basis.forward * double{wish.forward} + basis.right * double{wish.side});
}

math::Vec3 capped(const math::Vec3& velocity, float max_speed) {
  const float speed = glm::length(velocity);
  return speed > max_speed ? velocity * (max_speed / speed) : velocity;
}

math::Vec3 bounded(math::Vec3 velocity, float max_velocity) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isnan(velocity[axis])) velocity[axis] = 0;
    velocity[axis] = std::max(std::min(velocity[axis], max_velocity), -max_velocity);
  }
  return velocity;
}

float roll_deg(const math::Vec3& angles_deg, const math::Vec3& velocity) {
  const math::Basis basis = math::basis_from_angles(angles_deg);
  const auto side = static_cast<float>(glm::dot(math::Vec3d(velocity), basis.right));
  return std::clamp(side / kRollSpeed, -1.0f, 1.0f) * kRollAngle_deg;
}

math::Vec3 faded_punch(const math::Vec3& punch_deg, float tick_s) {
  const float length = glm::length(punch_deg);
  return direction_of(punch_deg, length) * std::max(length - kPunchFade_deg * tick_s, 0.0f);
}

}  // namespace temblor::movement
