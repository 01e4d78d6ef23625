#include "scripted_player/decisions/view.h"

#include <algorithm>
#include <cmath>

#include "scripted_player/decisions/senses.h"

namespace temblor::player {
namespace {

// Degrees per second at haste 1.
constexpr float kMaxRate_deg = 260;
// Stiffness of the spring in 1/s at haste 1.
constexpr float kStiffness = 9;
// Degrees per second. If the wanted angles turn faster, the target has changed and must not be led.
constexpr float kFollowed_deg = 240;
constexpr float kMaxPitch_deg = 65;

}  // namespace

void View::set(const math::Vec3& angles_deg) {
  angles_deg_ = angles_deg;
  rate_ = math::Vec3(0.0f);
}

// acceleration = stiffness^2 * error - 2 * stiffness * rate: critically damped. Integrated by the
// semi-implicit Euler method: first the rate, then the angle with the new rate. Pitch and yaw are
// independent.
void View::turn(const math::Vec3& wanted_deg, float haste, float seconds) {
  const float stiffness = kStiffness * haste, most = kMaxRate_deg * haste;
  const math::Vec3 wanted(std::clamp(wanted_deg.x, -kMaxPitch_deg, kMaxPitch_deg), wanted_deg.y, 0);
  for (int axis = 0; axis < 2; ++axis) {
    // A spring lags behind a moving target by 2 / stiffness seconds; aim ahead to compensate.
    const float moves = angle_difference_deg(wanted_[axis], wanted[axis]) / seconds;
    const float lead = std::abs(moves) < kFollowed_deg ? moves * 2 / stiffness : 0;
    const float missing = angle_difference_deg(angles_deg_[axis], wanted[axis] + lead);
    const float pull = stiffness * stiffness * missing - 2 * stiffness * rate_[axis];
    rate_[axis] = std::clamp(rate_[axis] + pull * seconds, -most, most);
    angles_deg_[axis] = std::remainder(angles_deg_[axis] + rate_[axis] * seconds, 360.0f);
  }
  angles_deg_.z = 0;
  wanted_ = wanted;
}

}  // namespace temblor::player
