#include "client/input/player_input.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace temblor::client {
namespace {

using platform::PadAxis;

// The longest time between two frames that turns the view: a hitch must not turn the player around.
constexpr double kMaxStep_s = 0.1;
constexpr float kDriftAcceleration_deg = 500;
// How long the player must walk forward before the view drifts back.
constexpr double kDriftDelay_s = 0.15;
// Bits of net::Move::buttons.
constexpr std::uint8_t kAttackBit = 1, kJumpBit = 2;

// Components of view angles, in degrees. Positive pitch looks down.
enum : std::size_t { kPitch = 0, kYaw = 1, kRoll = 2 };

// Returns the same direction in [-180, 180].
float wrap_yaw_deg(float yaw_deg) {
  return std::remainder(yaw_deg, 360.0f);
}

// Moves carry whole units per second as 16 bits.
std::int16_t to_speed(float units_per_second) {
  constexpr float kMin = std::numeric_limits<std::int16_t>::min(),
                  kMax = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(units_per_second, kMin, kMax)));
}

}  // namespace

math::Vec2 shape_stick(math::Vec2 stick, float dead_zone, float exponent) {
  // The curve starts at the edge of the dead zone, so that the smallest push beyond it moves slowly.
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

// Input turns the view first, then it drifts, then it is limited. Any turn up or down by the player ends a
// drift.
void PlayerInput::look(const LookInput& input, const InputSettings& settings) {
  const double elapsed_s = std::clamp(input.time_s - last_look_s_, 0.0, kMaxStep_s);
  last_look_s_ = input.time_s;
  const bool looks_freely = is_looking_freely(settings);
  if (was_looking_freely_ && !looks_freely && settings.look_spring) centering_ = true;
  was_looking_freely_ = looks_freely;
  const float pitch_before_deg = angles_deg_[kPitch];
  look_by_mouse(input, settings);
  look_by_keys(input, elapsed_s, settings);
  if (settings.gamepad) look_by_stick(input, elapsed_s, settings);
  if (angles_deg_[kPitch] != pitch_before_deg) centering_ = false;
  if (looks_freely || angles_deg_[kPitch] != pitch_before_deg) walked_s_ = 0;
  drift_pitch(input, elapsed_s, settings);
  angles_deg_[kPitch] = std::clamp(angles_deg_[kPitch], settings.min_pitch_deg, settings.max_pitch_deg);
  angles_deg_[kYaw] = wrap_yaw_deg(angles_deg_[kYaw]);
  angles_deg_[kRoll] = 0;
}

// Zoom slows turning in proportion to the magnification, so that aiming feels alike. Without mouse look, or
// while strafing, the mouse moves the player: its counts collect in mouse_wish_ until the next move.
void PlayerInput::look_by_mouse(const LookInput& input, const InputSettings& settings) {
  const math::Vec2 counts = std::exchange(mouse_, math::Vec2(0.0f)) * (settings.sensitivity / input.zoom);
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

// Keys that were held for part of the frame turn for that part.
void PlayerInput::look_by_keys(const LookInput& input, double elapsed_s, const InputSettings& settings) {
  const auto held_s = [&](Button button) {
    return static_cast<float>(std::min(buttons_[button].take_held_s(input.time_s), elapsed_s));
  };
  const float factor = (buttons_[Button::kSpeed].is_down() ? settings.fast_turn_factor : 1.0f) / input.zoom;
  if (!buttons_[Button::kStrafe].is_down())
    angles_deg_[kYaw] +=
        (held_s(Button::kTurnLeft) - held_s(Button::kTurnRight)) * settings.yaw_speed_deg * factor;
  float down_s = held_s(Button::kLookDown) - held_s(Button::kLookUp);
  if (buttons_[Button::kKeyLook].is_down()) down_s += held_s(Button::kBack) - held_s(Button::kForward);
  angles_deg_[kPitch] += down_s * settings.pitch_speed_deg * factor;
}

// A stick turns at a speed, so its deflection is multiplied by time.
void PlayerInput::look_by_stick(const LookInput& input, double elapsed_s, const InputSettings& settings) {
  const math::Vec2 look = shape_stick(stick(settings.swap_sticks ? PadAxis::kLeftX : PadAxis::kRightX),
                                      settings.stick_dead_zone_look, settings.stick_exponent_look) *
                          (static_cast<float>(elapsed_s) / input.zoom);
  angles_deg_[kYaw] -= look.x * settings.stick_yaw_deg;
  angles_deg_[kPitch] += look.y * settings.stick_pitch_deg * (settings.invert_stick ? -1.0f : 1.0f);
}

// Turns the view back to the server's ideal pitch, faster and faster: on request, and for players who do not
// look up and down themselves, after walking forward for a moment.
void PlayerInput::drift_pitch(const LookInput& input, double elapsed_s, const InputSettings& settings) {
  const bool walks =
      buttons_[Button::kForward].is_down() && !buttons_[Button::kKeyLook].is_down() && input.may_drift;
  walked_s_ = walks ? walked_s_ + elapsed_s : 0;
  const bool drifts = !is_looking_freely(settings) && input.may_drift && walked_s_ > kDriftDelay_s;
  const float remaining_deg = input.ideal_pitch_deg - angles_deg_[kPitch];
  if (!(centering_ || drifts) || remaining_deg == 0) {
    centering_ = false;
    drift_speed_deg_ = 0;
    return;
  }
  const float step_s = static_cast<float>(elapsed_s);
  const float step_deg = (drift_speed_deg_ + kDriftAcceleration_deg * step_s / 2) * step_s;
  drift_speed_deg_ += kDriftAcceleration_deg * step_s;
  angles_deg_[kPitch] += std::clamp(remaining_deg, -step_deg, step_deg);
}

// The least time avoids a division by 0 for two moves at the same moment.
net::Move PlayerInput::take_move(double time_s, const InputSettings& settings) {
  const double elapsed_s = std::clamp(time_s - last_move_s_, 1e-4, kMaxStep_s);
  last_move_s_ = time_s;
  // The share of the time that the button was held: half a tick of +forward is half the speed.
  const auto held_share = [&](Button button) {
    return static_cast<float>(std::min(buttons_[button].take_held_s(time_s) / elapsed_s, 1.0));
  };
  math::Vec3 wish(0.0f);  // forward, side, up
  if (!buttons_[Button::kKeyLook].is_down())
    wish.x = held_share(Button::kForward) * settings.forward_speed -
             held_share(Button::kBack) * settings.back_speed;
  float sideways = held_share(Button::kMoveRight) - held_share(Button::kMoveLeft);
  if (buttons_[Button::kStrafe].is_down())
    sideways += held_share(Button::kTurnRight) - held_share(Button::kTurnLeft);
  wish.y = sideways * settings.side_speed;
  wish.z = (held_share(Button::kMoveUp) - held_share(Button::kMoveDown)) * settings.up_speed;
  const bool runs = buttons_[Button::kSpeed].is_down() != settings.always_run;
  if (runs) wish *= settings.run_factor;
  if (settings.gamepad) {
    const math::Vec2 walk = shape_stick(stick(settings.swap_sticks ? PadAxis::kRightX : PadAxis::kLeftX),
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

// Takes the move from a copy, so nothing is used up.
net::Move PlayerInput::peek_move(double time_s, const InputSettings& settings) const {
  PlayerInput copy = *this;
  return copy.take_move(time_s, settings);
}

}  // namespace temblor::client
