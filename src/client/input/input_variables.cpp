#include "client/input/input_variables.h"

#include <fmt/format.h>

#include <optional>

#include "command/text.h"

namespace temblor::client {

InputVariables::InputVariables(command::Variables& variables) {
  const InputSettings d;
  const auto number = [&](const char* name, float value, double min, double max, const char* help) {
    // Defaults are decimal numbers that a float does not hold exactly: 0.022, not 0.02199999988.
    return variables.add_float(name, std::stod(fmt::format("{}", value)), min, max, help);
  };
  sensitivity_ = number("sensitivity", d.sensitivity, 0, 100, "How far the mouse turns the view.");
  yaw_ = number("m_yaw", d.mouse_yaw_deg, -1, 1, "Degrees to the side for each count of the mouse.");
  pitch_ = number("m_pitch", d.mouse_pitch_deg, -1, 1,
                  "Degrees up and down for each count of the mouse; below 0: turned over.");
  side_ = number("m_side", d.mouse_side, -10, 10, "Sideways speed for each count, with +strafe.");
  forward_ = number("m_forward", d.mouse_forward, -10, 10, "Speed ahead for each count, without free look.");
  invert_ = variables.add_bool("m_invert", d.invert_mouse, "Mouse away from you looks down.");
  free_look_ = variables.add_bool("freelook", d.free_look, "The mouse looks up and down.");
  look_spring_ = variables.add_bool("lookspring", d.look_spring,
                                    "The view goes back to straight ahead when free looking ends.");
  look_strafe_ =
      variables.add_bool("lookstrafe", d.look_strafe, "The mouse steps aside while looking freely.");
  always_run_ = variables.add_bool("cl_alwaysrun", d.always_run, "Runs; the run key walks.");
  forward_speed_ =
      number("cl_forwardspeed", d.forward_speed, 0, 2000, "Walking speed ahead, units a second.");
  back_speed_ = number("cl_backspeed", d.back_speed, 0, 2000, "Walking speed backwards.");
  side_speed_ = number("cl_sidespeed", d.side_speed, 0, 2000, "Walking speed to the side.");
  up_speed_ = number("cl_upspeed", d.up_speed, 0, 2000, "Swimming speed up and down.");
  run_factor_ = number("cl_movespeedkey", d.run_factor, 0, 10, "How much faster running is.");
  yaw_speed_ = number("cl_yawspeed", d.yaw_speed_deg, 0, 1000, "Degrees a second that turning keys turn.");
  pitch_speed_ = number("cl_pitchspeed", d.pitch_speed_deg, 0, 1000, "Degrees a second, up and down.");
  turn_factor_ =
      number("cl_anglespeedkey", d.fast_turn_factor, 0, 10, "How much faster keys turn with the run key.");
  min_pitch_ = number("cl_minpitch", d.min_pitch_deg, -90, 0, "How far up one can look, degrees below 0.");
  max_pitch_ = number("cl_maxpitch", d.max_pitch_deg, 0, 90, "How far down one can look, degrees.");
  gamepad_ = variables.add_bool("joy_enable", d.gamepad, "Uses the gamepad's sticks.");
  dead_zone_look_ = number("joy_deadzone_look", d.stick_dead_zone_look, 0, 0.9,
                           "How far the looking stick is pushed before it counts.");
  dead_zone_move_ =
      number("joy_deadzone_move", d.stick_dead_zone_move, 0, 0.9, "Alike, of the walking stick.");
  exponent_look_ = number("joy_exponent", d.stick_exponent_look, 0.25, 8,
                          "Curve of the looking stick: 1 even, more: finer near the middle.");
  exponent_move_ =
      number("joy_exponent_move", d.stick_exponent_move, 0.25, 8, "Alike, of the walking stick.");
  stick_yaw_ =
      number("joy_sensitivity_yaw", d.stick_yaw_deg, 0, 2000, "Degrees a second, pushed all the way.");
  stick_pitch_ = number("joy_sensitivity_pitch", d.stick_pitch_deg, 0, 2000, "Alike, up and down.");
  invert_stick_ = variables.add_bool("joy_invert", d.invert_stick, "Pushing the looking stick looks down.");
  swap_sticks_ = variables.add_bool("joy_swapmovelook", d.swap_sticks, "Left looks and right walks.");
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

// Which key holds a button down; one that is told wrongly is key 0, as one that is not told.
int holder_of(command::Console::Arguments arguments) {
  const auto number = arguments.size() > 1 ? command::parse_whole_number(arguments[1]) : std::nullopt;
  return static_cast<int>(number.value_or(0));
}

}  // namespace

void add_input_commands(command::Console& io_console, PlayerInput& io_input, const double& event_time_s) {
  using Arguments = command::Console::Arguments;
  for (std::size_t i = 0; i < kButtons; ++i) {
    const Button button{static_cast<std::uint8_t>(i)};
    const auto [name, help] = name_of(button);
    io_console.add_command(fmt::format("+{}", name), help,
                           [&io_input, &event_time_s, button](Arguments arguments) {
                             io_input.buttons()[button].press(holder_of(arguments), event_time_s);
                           });
    io_console.add_command(fmt::format("-{}", name), fmt::format("Ends +{}.", name),
                           [&io_input, &event_time_s, button](Arguments arguments) {
                             io_input.buttons()[button].release(holder_of(arguments), event_time_s);
                           });
  }
  io_console.add_command(
      "impulse", "impulse N tells the game's code a number: 1 to 8 choose weapons.",
      [&io_console, &io_input](Arguments arguments) {
        const auto number = arguments.size() == 2 ? command::parse_whole_number(arguments[1]) : std::nullopt;
        if (!number || *number < 0 || *number > 255)
          return io_console.print_error("impulse N: a number from 0 to 255");
        io_input.set_impulse(static_cast<std::uint8_t>(*number));
      });
  io_console.add_command("centerview", "Looks straight ahead again.",
                         [&io_input](Arguments) { io_input.center_view(); });
  io_console.add_command("force_centerview", "Looks straight ahead at once.", [&io_input](Arguments) {
    math::Vec3 angles_deg = io_input.view_angles_deg();
    angles_deg.x = 0;
    io_input.set_view_angles(angles_deg);
  });
}

}  // namespace temblor::client
