#include "client/view/view_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/angles.h"

namespace temblor::client {

// A sine of time, scaled by horizontal speed: 2 % of the speed in units, of which 30 % are constant.
float compute_bob(double time_s, const math::Vec3& velocity, double cycle_s, double up) {
  constexpr double kPerSpeed = 0.02, kSteady = 0.3;
  if (!(cycle_s > 0)) return 0;
  const double phase = time_s / cycle_s - std::floor(time_s / cycle_s);
  const double half_turns = phase < up ? phase / up : 1 + (phase - up) / (1 - up);
  const double size = std::hypot(double{velocity.x}, double{velocity.y}) * kPerSpeed;
  const double bob = size * kSteady + size * (1 - kSteady) * std::sin(std::numbers::pi * half_turns);
  return static_cast<float>(std::clamp(bob, -7.0, 4.0));
}

float compute_strafe_roll_deg(const math::Vec3& velocity, const math::Vec3& right) {
  constexpr float kMaxSpeed = 200, kMaxRoll_deg = 2;
  return std::clamp(glm::dot(velocity, right) / kMaxSpeed, -1.0f, 1.0f) * kMaxRoll_deg;
}

math::Vec3 compute_idle_sway_deg(double time_s) {
  return {0.3 * std::sin(time_s), 0.3 * std::sin(2 * time_s), 0.1 * std::sin(0.5 * time_s)};
}

// In the air, and on the way down, the eyes stay with the body.
float StairSmoothing::advance(float floor_z, bool on_ground, double elapsed_s) {
  constexpr float kMaxLag = 12, kSpeed = 80;
  if (!on_ground || floor_z <= eyes_z_) {
    eyes_z_ = floor_z;
    return 0;
  }
  const float risen = eyes_z_ + kSpeed * static_cast<float>(elapsed_s);
  eyes_z_ = std::clamp(risen, floor_z - kMaxLag, floor_z);
  return eyes_z_ - floor_z;
}

// Half the damage, at least 10, times 0.6 degrees: from the front it throws the head back, from the side it
// rolls it.
void DamageKick::add(const net::Damage& damage, const math::Vec3& body_world, float body_yaw_deg,
                     double time_s) {
  constexpr float kDegreesPerCount = 0.6f;
  const float count = std::max(10.0f, static_cast<float>(damage.armor + damage.blood) / 2);
  const math::Vec3 direction = damage.from - body_world;
  const float distance = glm::length(direction);
  const math::Vec3 from = distance > 0 ? direction / distance : math::Vec3(0.0f);
  const math::Basis body = math::basis_from_angles({0, body_yaw_deg, 0});
  kick_deg_ = {count * kDegreesPerCount * glm::dot(from, math::Vec3(body.forward)), 0,
               count * kDegreesPerCount * glm::dot(from, math::Vec3(body.right))};
  since_s_ = time_s;
}

math::Vec3 DamageKick::angles_deg(double time_s, double duration_s) const {
  if (duration_s <= 0) return math::Vec3{0.0f};
  const double left = 1 - (time_s - since_s_) / duration_s;
  return kick_deg_ * static_cast<float>(std::max(0.0, left));
}

// A new target starts a new step from the current value, so there is no jump.
void EasedVector::advance(const math::Vec3& target, double time_s) {
  constexpr double kMaxEase_s = 0.1;
  if (target == to_) return;
  from_ = value(time_s);
  to_ = target;
  step_s_ = std::clamp(time_s - changed_s_, 0.0, kMaxEase_s);
  changed_s_ = time_s;
}

void EasedVector::jump(const math::Vec3& target, double time_s) {
  from_ = to_ = target;
  changed_s_ = time_s;
  step_s_ = 0;
}

math::Vec3 EasedVector::value(double time_s) const {
  const double elapsed_s = time_s - changed_s_;
  if (!(elapsed_s < step_s_)) return to_;
  return from_ + (to_ - from_) * static_cast<float>(std::max(0.0, elapsed_s) / step_s_);
}

}  // namespace temblor::client
