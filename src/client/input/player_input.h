// From keys, mouse and sticks to where the player looks and what he wishes to do. Looking is immediate and
// exact for any rate of frames; wishes are collected until a move is sent.
#pragma once

#include <array>
#include <cstdint>

#include "client/input/buttons.h"
#include "math/vec.h"
#include "net/protocol/client_message.h"
#include "platform/key.h"

namespace temblor::client {

// By the names of their console variables, which input_variables.h registers.
struct InputSettings {
  float sensitivity = 3;                                   // degrees a count: times m_yaw
  float mouse_yaw_deg = 0.022f, mouse_pitch_deg = 0.022f;  // m_yaw, m_pitch
  float mouse_side = 0.8f, mouse_forward = 1;              // m_side, m_forward
  bool invert_mouse = false;                               // m_invert
  bool free_look = true;                                   // freelook
  bool look_spring = false, look_strafe = false;           // lookspring, lookstrafe
  bool always_run = true;                                  // cl_alwaysrun
  float forward_speed = 200, back_speed = 200, side_speed = 350, up_speed = 200;
  float run_factor = 2;  // cl_movespeedkey
  float yaw_speed_deg = 140, pitch_speed_deg = 150, fast_turn_factor = 1.5f;
  float min_pitch_deg = -70, max_pitch_deg = 80;  // cl_minpitch, cl_maxpitch
  bool gamepad = true;                            // joy_enable
  float stick_dead_zone_look = 0.175f, stick_dead_zone_move = 0.175f;
  float stick_exponent_look = 2, stick_exponent_move = 2;
  float stick_yaw_deg = 240, stick_pitch_deg = 130;  // a second, pushed all the way
  bool invert_stick = false, swap_sticks = false;
};

// What looking depends on besides.
struct LookMoment {
  double time_s = 0;          // of the window's clock
  float zoom = 1;             // of the field of view: turning is slowed by as much as things are larger
  float ideal_pitch_deg = 0;  // where the server would have the player look
  bool may_drift = false;     // he walks on the ground
};

// A stick with a dead zone around its middle, and a curve from there to its end. Both axes -1 to 1 in, and
// within the unit circle out.
math::Vec2 shaped_stick(math::Vec2 stick, float dead_zone, float exponent);

class PlayerInput {
 public:
  Buttons& buttons() { return buttons_; }

  void add_mouse(float right, float down);
  void set_axis(platform::PadAxis axis, float value);
  void set_impulse(std::uint8_t impulse) { impulse_ = impulse; }
  void center_view() { centering_ = true; }

  // The server has turned the player.
  void set_view_angles(const math::Vec3& angles_deg);
  const math::Vec3& view_angles_deg() const { return angles_deg_; }

  // Takes what has come since the last call. Once a frame, after its events.
  void look(const LookMoment& moment, const InputSettings& settings);
  // What the player wished since the last move; time_s is left to the connection.
  net::Move take_move(double time_s, const InputSettings& settings);
  // The same, left to be taken: what a prediction goes on with in a frame in which none is.
  net::Move peek_move(double time_s, const InputSettings& settings) const;

 private:
  void look_by_mouse(const LookMoment& moment, const InputSettings& settings);
  void look_by_keys(const LookMoment& moment, double passed_s, const InputSettings& settings);
  void look_by_stick(const LookMoment& moment, double passed_s, const InputSettings& settings);
  void drift(const LookMoment& moment, double passed_s, const InputSettings& settings);
  bool is_looking_freely(const InputSettings& settings) const;
  math::Vec2 stick(platform::PadAxis x) const;

  Buttons buttons_;
  math::Vec3 angles_deg_{0.0f};
  math::Vec2 mouse_{0.0f};       // counts, not yet taken
  math::Vec2 mouse_wish_{0.0f};  // side and forward, for the next move
  std::array<float, platform::kPadAxes> axes_{};
  std::uint8_t impulse_ = 0;
  bool centering_ = false, was_looking_freely_ = true;
  float drift_speed_deg_ = 0;  // a second
  double walked_s_ = 0;        // ahead, without looking
  double looked_at_s_ = 0, moved_at_s_ = 0;
};

}  // namespace temblor::client
