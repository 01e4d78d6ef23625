#include "client/input/input_variables.h"

#include <fmt/format.h>

#include <optional>

#include "command/text.h"

namespace temblor::client {

InputVariables::InputVariables(command::Variables& variables) {
  const InputSettings d;
  const auto number = [&](const char* name, float value, double min, double max, const char* help) {
    // Formats the float first: 0.022 rather than the nearest double of the float, 0.02199999988.
    return variables.add_float(name, std::stod(fmt::format("{}", value)), min, max, help);
  };
  sensitivity_ = number("sensitivity", d.sensitivity, 0, 100, "Mouse sensitivity.");
  yaw_ = number("m_yaw", d.mouse_yaw_deg, -1, 1, "Degrees the view turns sideways per mouse count.");
  pitch_ = number("m_pitch", d.mouse_pitch_deg, -1, 1,
                  "Degrees the view turns up or down per mouse count. Negative values invert it.");
  side_ = number("m_side", d.mouse_side, -10, 10, "Strafe speed per mouse count, with +strafe.");
  forward_ =
      number("m_forward", d.mouse_forward, -10, 10, "Forward speed per mouse count, without mouse look.");
  invert_ =
      variables.add_bool("m_invert", d.invert_mouse, "Inverts the mouse: pushing it forward looks down.");
  free_look_ = variables.add_bool("freelook", d.free_look, "The mouse always looks up and down.");
  look_spring_ = variables.add_bool("lookspring", d.look_spring, "The view levels out when mouse look ends.");
  look_strafe_ = variables.add_bool("lookstrafe", d.look_strafe, "The mouse strafes while mouse look is on.");
  always_run_ = variables.add_bool("cl_alwaysrun", d.always_run, "Runs by default. The run key then walks.");
  forward_speed_ = number("cl_forwardspeed", d.forward_speed, 0, 2000, "Forward speed, in units per second.");
  back_speed_ = number("cl_backspeed", d.back_speed, 0, 2000, "Backward speed.");
  side_speed_ = number("cl_sidespeed", d.side_speed, 0, 2000, "Strafe speed.");
  up_speed_ = number("cl_upspeed", d.up_speed, 0, 2000, "Swim speed up and down.");
  run_factor_ = number("cl_movespeedkey", d.run_factor, 0, 10, "How many times faster running is.");
  yaw_speed_ =
      number("cl_yawspeed", d.yaw_speed_deg, 0, 1000, "Turn speed of the turn keys, in degrees per second.");
  pitch_speed_ = number("cl_pitchspeed", d.pitch_speed_deg, 0, 1000,
                        "Look speed of the look keys, in degrees per second.");
  turn_factor_ =
      number("cl_anglespeedkey", d.fast_turn_factor, 0, 10, "How many times faster you turn while running.");
  // Stock defaults: 70 degrees up, 80 down.
  min_pitch_ =
      number("cl_minpitch", d.min_pitch_deg, -90, 0, "How far up you can look, in negative degrees.");
  max_pitch_ = number("cl_maxpitch", d.max_pitch_deg, 0, 90, "How far down you can look, in degrees.");
  gamepad_ = variables.add_bool("joy_enable", d.gamepad, "Uses the gamepad.");
  dead_zone_look_ = number("joy_deadzone_look", d.stick_dead_zone_look, 0, 0.9,
                           "How far to push the look stick before it responds.");
  dead_zone_move_ = number("joy_deadzone_move", d.stick_dead_zone_move, 0, 0.9,
                           "How far to push the move stick before it responds.");
  exponent_look_ = number("joy_exponent", d.stick_exponent_look, 0.25, 8,
                          "Response of the look stick. 1: linear; higher: finer near the center.");
  exponent_move_ = number("joy_exponent_move", d.stick_exponent_move, 0.25, 8,
                          "Response of the move stick. 1: linear; higher: finer near the center.");
  stick_yaw_ = number("joy_sensitivity_yaw", d.stick_yaw_deg, 0, 2000,
                      "Sideways look speed of the stick, in degrees per second.");
  stick_pitch_ = number("joy_sensitivity_pitch", d.stick_pitch_deg, 0, 2000,
                        "Up and down look speed of the stick, in degrees per second.");
  invert_stick_ = variables.add_bool("joy_invert", d.invert_stick,
                                     "Inverts the look stick: pushing it forward looks down.");
  swap_sticks_ = variables.add_bool("joy_swapmovelook", d.swap_sticks,
                                    "Swaps the sticks: look with the left, move with the right.");
}

InputSettings InputVariables::read(const command::Variables& v) const {
  const auto number = [&](command::VariableIndex index) { return static_cast<float>(v.float_value(index)); };
  InputSettings s;
  s.sensitivity = number(sensitivity_);
  s.mouse_yaw_deg = number(yaw_);
  s.mouse_pitch_deg = number(pitch_);
  s.mouse_side = number(side_);
  s.mouse_forward = number(forward_);
  s.invert_mouse = v.bool_value(invert_);
  s.free_look = v.bool_value(free_look_);
  s.look_spring = v.bool_value(look_spring_);
  s.look_strafe = v.bool_value(look_strafe_);
  s.always_run = v.bool_value(always_run_);
  s.forward_speed = number(forward_speed_);
  s.back_speed = number(back_speed_);
  s.side_speed = number(side_speed_);
  s.up_speed = number(up_speed_);
  s.run_factor = number(run_factor_);
  s.yaw_speed_deg = number(yaw_speed_);
  s.pitch_speed_deg = number(pitch_speed_);
  s.fast_turn_factor = number(turn_factor_);
  s.min_pitch_deg = number(min_pitch_);
  s.max_pitch_deg = number(max_pitch_);
  s.gamepad = v.bool_value(gamepad_);
  s.stick_dead_zone_look = number(dead_zone_look_);
  s.stick_dead_zone_move = number(dead_zone_move_);
  s.stick_exponent_look = number(exponent_look_);
  s.stick_exponent_move = number(exponent_move_);
  s.stick_yaw_deg = number(stick_yaw_);
  s.stick_pitch_deg = number(stick_pitch_);
  s.invert_stick = v.bool_value(invert_stick_);
  s.swap_sticks = v.bool_value(swap_sticks_);
  return s;
}

namespace {

// The key that runs a button command, from its argument; 0 for a typed command or a bad number.
int parse_holder(command::Console::Arguments arguments) {
  const auto number = arguments.size() > 1 ? command::parse_whole_number(arguments[1]) : std::nullopt;
  return static_cast<int>(number.value_or(0));
}

}  // namespace

void add_input_commands(command::Console& io_console, PlayerInput& io_input, const double& event_time_s) {
  using Arguments = command::Console::Arguments;
  for (std::size_t i = 0; i < kButtons; ++i) {
    const Button button{static_cast<std::uint8_t>(i)};
    const auto [name, help] = button_name(button);
    io_console.add_command(fmt::format("+{}", name), help,
                           [&io_input, &event_time_s, button](Arguments arguments) {
                             io_input.buttons()[button].press(parse_holder(arguments), event_time_s);
                           });
    io_console.add_command(fmt::format("-{}", name), fmt::format("Ends +{}.", name),
                           [&io_input, &event_time_s, button](Arguments arguments) {
                             io_input.buttons()[button].release(parse_holder(arguments), event_time_s);
                           });
  }
  io_console.add_command(
      "impulse", "impulse N: selects a weapon (1 to 8) or triggers another game action.",
      [&io_console, &io_input](Arguments arguments) {
        const auto number = arguments.size() == 2 ? command::parse_whole_number(arguments[1]) : std::nullopt;
        if (!number || *number < 0 || *number > 255)
          return io_console.print_error("Usage: impulse N, with N from 0 to 255");
        io_input.set_impulse(static_cast<std::uint8_t>(*number));
      });
  io_console.add_command("centerview", "Centers the view smoothly.",
                         [&io_input](Arguments) { io_input.center_view(); });
  io_console.add_command("force_centerview", "Centers the view at once.", [&io_input](Arguments) {
    math::Vec3 angles_deg = io_input.view_angles_deg();
    angles_deg.x = 0;
    io_input.set_view_angles(angles_deg);
  });
}

}  // namespace temblor::client
