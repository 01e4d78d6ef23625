// Console variables and commands for the player's controls. Names and defaults are stock Quake's where it has
// them; joy_ variables are this engine's own.
#pragma once

#include "client/input/player_input.h"
#include "command/console.h"
#include "command/variables.h"

namespace temblor::client {

class InputVariables {
 public:
  // Registers the variables. Their defaults are those of InputSettings.
  explicit InputVariables(command::Variables& variables);
  // The current settings. `variables` is the table that the constructor received.
  InputSettings read(const command::Variables& variables) const;

 private:
  command::VariableIndex sensitivity_, yaw_, pitch_, side_, forward_, invert_, free_look_, look_spring_,
      look_strafe_, always_run_, forward_speed_, back_speed_, side_speed_, up_speed_, run_factor_, yaw_speed_,
      pitch_speed_, turn_factor_, min_pitch_, max_pitch_, gamepad_, dead_zone_look_, dead_zone_move_,
      exponent_look_, exponent_move_, stick_yaw_, stick_pitch_, invert_stick_, swap_sticks_;
};

// Registers +forward, -forward and so on for each Button, and impulse, centerview and force_centerview.
// `event_time_s` is read when a command runs: the time from which it counts. It and `io_input` must
// outlive the console.
void add_input_commands(command::Console& io_console, PlayerInput& io_input, const double& event_time_s);

}  // namespace temblor::client
