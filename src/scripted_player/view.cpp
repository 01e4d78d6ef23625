#include "scripted_player/view.h"

#include <algorithm>
#include <cmath>

#include "scripted_player/decisions/senses.h"

namespace temblor::player {
namespace {

constexpr float kMaxRate_deg = 260;   // a second, at haste 1
constexpr float kStiffness = 9;       // of the spring that pulls the view, 1/s at haste 1
constexpr float kFollowed_deg = 240;  // a second: faster is another target
constexpr float kMaxPitch_deg = 65;

}  // namespace

void View::set(const math::Vec3& angles_deg) {
  angles_deg_ = angles_deg;
  rate_ = math::Vec3(0.0f);
}

// A critically damped spring, its speed bounded.
void View::turn(const math::Vec3& wanted_deg, float haste, float seconds) {
  const float stiffness = kStiffness * haste, most = kMaxRate_deg * haste;
  const math::Vec3 wanted(std::clamp(wanted_deg.x, -kMaxPitch_deg, kMaxPitch_deg), wanted_deg.y, 0);
  for (int axis = 0; axis < 2; ++axis) {
    // A spring lags behind what moves; a hand does not.
    const float moves = turn_between_deg(wanted_[axis], wanted[axis]) / seconds;
    const float lead = std::abs(moves) < kFollowed_deg ? moves * 2 / stiffness : 0;
    const float missing = turn_between_deg(angles_deg_[axis], wanted[axis] + lead);
    const float pull = stiffness * stiffness * missing - 2 * stiffness * rate_[axis];
    rate_[axis] = std::clamp(rate_[axis] + pull * seconds, -most, most);
    angles_deg_[axis] = std::remainder(angles_deg_[axis] + rate_[axis] * seconds, 360.0f);
  }
  angles_deg_.z = 0;
  wanted_ = wanted;
}

}  // namespace temblor::player
