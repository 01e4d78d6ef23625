// Turns keys, mouse and sticks into view angles and moves.
//
//   mouse, sticks, turn keys --look(), each frame--> view angles, used by this frame's picture at once
//   action keys, impulse ----take_move(), each tick--> net::Move to the server
//
// Looking is immediate and exact at any frame rate; movement is collected until a move is sent. Angles are
// the client's own: the server only sets them when game code turns the player.
#pragma once

#include <array>
#include <cstdint>

#include "client/input/buttons.h"
#include "math/vec.h"
#include "net/protocol/client_message.h"
#include "platform/key.h"

namespace temblor::client {

// The values of the console variables that input_variables.h registers. Speeds are in units per second, those
// of angles in degrees per second.
struct InputSettings {
  // Times mouse_yaw_deg gives degrees per mouse count.
  float sensitivity = 3;
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
  // Degrees per second at full deflection.
  float stick_yaw_deg = 240, stick_pitch_deg = 130;
  bool invert_stick = false, swap_sticks = false;
};

// Further inputs of looking.
struct LookInput {
  // The frame's time, on the window's clock.
  double time_s = 0;
  // Magnification: turning slows down by this factor.
  float zoom = 1;
  // The pitch that the server suggests, for slopes.
  float ideal_pitch_deg = 0;
  // The player is on the ground.
  bool may_drift = false;
};

// Applies a dead zone around the center and a curve from there to the end. Input axes are -1 to 1. The result
// is within the unit circle and has the stick's direction.
math::Vec2 shape_stick(math::Vec2 stick, float dead_zone, float exponent);

// All functions take times on the window's clock.
class PlayerInput {
 public:
  Buttons& buttons() { return buttons_; }

  // Store input for the next look() or take_move(): mouse counts, the position of an axis (-1 to 1), an
  // impulse (0: none; a later one replaces an earlier one), and a request to level the view.
  void add_mouse(float right, float down);
  void set_axis(platform::PadAxis axis, float value);
  void set_impulse(std::uint8_t impulse) { impulse_ = impulse; }
  void center_view() { centering_ = true; }

  // Sets the view because the server has turned the player. Ends a drift.
  void set_view_angles(const math::Vec3& angles_deg);
  const math::Vec3& view_angles_deg() const { return angles_deg_; }

  // Turns the view by the input since the last call. Call once a frame, after its events have been handled.
  void look(const LookInput& input, const InputSettings& settings);
  // Returns the move since the last call and starts a new one. The connection fills in the move's time.
  net::Move take_move(double time_s, const InputSettings& settings);
  // Like take_move(), but keeps the input: for the prediction in frames in which no move is sent.
  net::Move peek_move(double time_s, const InputSettings& settings) const;

 private:
  void look_by_mouse(const LookInput& input, const InputSettings& settings);
  void look_by_keys(const LookInput& input, double elapsed_s, const InputSettings& settings);
  void look_by_stick(const LookInput& input, double elapsed_s, const InputSettings& settings);
  void drift_pitch(const LookInput& input, double elapsed_s, const InputSettings& settings);
  bool is_looking_freely(const InputSettings& settings) const;
  math::Vec2 stick(platform::PadAxis x) const;

  Buttons buttons_;
  math::Vec3 angles_deg_{0.0f};
  // Mouse counts since look().
  math::Vec2 mouse_{0.0f};
  // Side and forward movement for the next move, units per second.
  math::Vec2 mouse_wish_{0.0f};
  std::array<float, platform::kPadAxes> axes_{};
  std::uint8_t impulse_ = 0;
  bool centering_ = false, was_looking_freely_ = true;
  // Degrees per second.
  float drift_speed_deg_ = 0;
  // Seconds of walking ahead without looking up or down.
  double walked_s_ = 0;
  double last_look_s_ = 0, last_move_s_ = 0;
};

}  // namespace temblor::client
