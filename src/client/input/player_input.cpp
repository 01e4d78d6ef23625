#include "client/input/player_input.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace temblor::client {
namespace {

using platform::PadAxis;

constexpr double kMaxStep_s = 0.1;  // after a hitch nobody wants to find himself turned around
constexpr float kDriftAcceleration_deg = 500;
constexpr double kDriftsAfter_s = 0.15;  // of walking ahead
constexpr std::uint8_t kAttackBit = 1, kJumpBit = 2;

enum : std::size_t { kPitch = 0, kYaw = 1, kRoll = 2 };

float turned_deg(float yaw_deg) {
  return std::remainder(yaw_deg, 360.0f);
}

std::int16_t to_speed(float units_per_second) {
  constexpr float kLeast = std::numeric_limits<std::int16_t>::min(),
                  kMost = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(units_per_second, kLeast, kMost)));
}

}  // namespace

math::Vec2 shaped_stick(math::Vec2 stick, float dead_zone, float exponent) {
  const float pushed = std::min(glm::length(stick), 1.0f);
  if (!(pushed > dead_zone)) return math::Vec2(0.0f);
  const float beyond = (pushed - dead_zone) / (1 - dead_zone);
  return glm::normalize(stick) * std::pow(beyond, exponent);
}

void PlayerInput::add_mouse(float right, float down) {
  mouse_ += math::Vec2(right, down);
}

void PlayerInput::set_axis(PadAxis axis, float value) {
  axes_[static_cast<std::size_t>(axis)] = value;
}

math::Vec2 PlayerInput::stick(PadAxis x) const {
  const auto index = static_cast<std::size_t>(x);
  return {axes_[index], axes_[index + 1]};
}

void PlayerInput::set_view_angles(const math::Vec3& angles_deg) {
  angles_deg_ = angles_deg;
  centering_ = false;
  drift_speed_deg_ = 0;
}

bool PlayerInput::is_looking_freely(const InputSettings& settings) const {
  return settings.free_look || buttons_[Button::kMouseLook].is_down();
}

void PlayerInput::look(const LookMoment& moment, const InputSettings& settings) {
  const double passed_s = std::clamp(moment.time_s - looked_at_s_, 0.0, kMaxStep_s);
  looked_at_s_ = moment.time_s;
  const bool looks_freely = is_looking_freely(settings);
  if (was_looking_freely_ && !looks_freely && settings.look_spring) centering_ = true;
  was_looking_freely_ = looks_freely;
  const float pitch_before_deg = angles_deg_[kPitch];
  look_by_mouse(moment, settings);
  look_by_keys(moment, passed_s, settings);
  if (settings.gamepad) look_by_stick(moment, passed_s, settings);
  if (angles_deg_[kPitch] != pitch_before_deg) centering_ = false;
  if (looks_freely || angles_deg_[kPitch] != pitch_before_deg) walked_s_ = 0;
  drift(moment, passed_s, settings);
  angles_deg_[kPitch] = std::clamp(angles_deg_[kPitch], settings.min_pitch_deg, settings.max_pitch_deg);
  angles_deg_[kYaw] = turned_deg(angles_deg_[kYaw]);
  angles_deg_[kRoll] = 0;
}

void PlayerInput::look_by_mouse(const LookMoment& moment, const InputSettings& settings) {
  const math::Vec2 counts = std::exchange(mouse_, math::Vec2(0.0f)) * (settings.sensitivity / moment.zoom);
  const bool strafes = buttons_[Button::kStrafe].is_down();
  const bool looks_freely = is_looking_freely(settings);
  if (strafes || (settings.look_strafe && looks_freely))
    mouse_wish_.x += counts.x * settings.mouse_side;
  else
    angles_deg_[kYaw] -= counts.x * settings.mouse_yaw_deg;
  if (looks_freely && !strafes)
    angles_deg_[kPitch] += counts.y * settings.mouse_pitch_deg * (settings.invert_mouse ? -1.0f : 1.0f);
  else
    mouse_wish_.y -= counts.y * settings.mouse_forward;
}

void PlayerInput::look_by_keys(const LookMoment& moment, double passed_s, const InputSettings& settings) {
  const auto held_s = [&](Button button) {
    return static_cast<float>(std::min(buttons_[button].take_held_s(moment.time_s), passed_s));
  };
  const float factor = (buttons_[Button::kSpeed].is_down() ? settings.fast_turn_factor : 1.0f) / moment.zoom;
  if (!buttons_[Button::kStrafe].is_down())
    angles_deg_[kYaw] +=
        (held_s(Button::kTurnLeft) - held_s(Button::kTurnRight)) * settings.yaw_speed_deg * factor;
  float down_s = held_s(Button::kLookDown) - held_s(Button::kLookUp);
  if (buttons_[Button::kKeyLook].is_down()) down_s += held_s(Button::kBack) - held_s(Button::kForward);
  angles_deg_[kPitch] += down_s * settings.pitch_speed_deg * factor;
}

void PlayerInput::look_by_stick(const LookMoment& moment, double passed_s, const InputSettings& settings) {
  const math::Vec2 look = shaped_stick(stick(settings.swap_sticks ? PadAxis::kLeftX : PadAxis::kRightX),
                                       settings.stick_dead_zone_look, settings.stick_exponent_look) *
                          (static_cast<float>(passed_s) / moment.zoom);
  angles_deg_[kYaw] -= look.x * settings.stick_yaw_deg;
  angles_deg_[kPitch] += look.y * settings.stick_pitch_deg * (settings.invert_stick ? -1.0f : 1.0f);
}

// Back to where the server would have him look: when asked to, and, for who does not look up and down
// himself, after he has walked ahead for a moment.
void PlayerInput::drift(const LookMoment& moment, double passed_s, const InputSettings& settings) {
  const bool walks =
      buttons_[Button::kForward].is_down() && !buttons_[Button::kKeyLook].is_down() && moment.may_drift;
  walked_s_ = walks ? walked_s_ + passed_s : 0;
  const bool drifts = !is_looking_freely(settings) && moment.may_drift && walked_s_ > kDriftsAfter_s;
  const float way_deg = moment.ideal_pitch_deg - angles_deg_[kPitch];
  if (!(centering_ || drifts) || way_deg == 0) {
    centering_ = false;
    drift_speed_deg_ = 0;
    return;
  }
  const float step_s = static_cast<float>(passed_s);
  const float step_deg = (drift_speed_deg_ + kDriftAcceleration_deg * step_s / 2) * step_s;
  drift_speed_deg_ += kDriftAcceleration_deg * step_s;
  angles_deg_[kPitch] += std::clamp(way_deg, -step_deg, step_deg);
}

net::Move PlayerInput::take_move(double time_s, const InputSettings& settings) {
  const double passed_s = std::clamp(time_s - moved_at_s_, 1e-4, kMaxStep_s);
  moved_at_s_ = time_s;
  // Which part of the time it was held.
  const auto share = [&](Button button) {
    return static_cast<float>(std::min(buttons_[button].take_held_s(time_s) / passed_s, 1.0));
  };
  math::Vec3 wish(0.0f);  // forward, side, up
  if (!buttons_[Button::kKeyLook].is_down())
    wish.x = share(Button::kForward) * settings.forward_speed - share(Button::kBack) * settings.back_speed;
  float aside = share(Button::kMoveRight) - share(Button::kMoveLeft);
  if (buttons_[Button::kStrafe].is_down()) aside += share(Button::kTurnRight) - share(Button::kTurnLeft);
  wish.y = aside * settings.side_speed;
  wish.z = (share(Button::kMoveUp) - share(Button::kMoveDown)) * settings.up_speed;
  const bool runs = buttons_[Button::kSpeed].is_down() != settings.always_run;
  if (runs) wish *= settings.run_factor;
  if (settings.gamepad) {
    const math::Vec2 walk = shaped_stick(stick(settings.swap_sticks ? PadAxis::kRightX : PadAxis::kLeftX),
                                         settings.stick_dead_zone_move, settings.stick_exponent_move) *
                            settings.run_factor;
    wish += math::Vec3(-walk.y * settings.forward_speed, walk.x * settings.side_speed, 0.0f);
  }
  const math::Vec2 mouse = std::exchange(mouse_wish_, math::Vec2(0.0f));
  return {.angles_deg = angles_deg_,
          .forward = to_speed(wish.x + mouse.y),
          .side = to_speed(wish.y + mouse.x),
          .up = to_speed(wish.z),
          .buttons = static_cast<std::uint8_t>((buttons_[Button::kAttack].take_was_down() ? kAttackBit : 0) |
                                               (buttons_[Button::kJump].take_was_down() ? kJumpBit : 0)),
          .impulse = std::exchange(impulse_, std::uint8_t{0})};
}

net::Move PlayerInput::peek_move(double time_s, const InputSettings& settings) const {
  PlayerInput copy = *this;
  return copy.take_move(time_s, settings);
}

}  // namespace temblor::client
