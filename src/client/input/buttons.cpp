#include "client/input/buttons.h"

#include <algorithm>
#include <utility>

namespace temblor::client {

ButtonName button_name(Button button) {
  static constexpr std::array<ButtonName, kButtons> kNames = {{
      {"forward", "Moves forward."},
      {"back", "Moves back."},
      {"moveleft", "Strafes left."},
      {"moveright", "Strafes right."},
      {"moveup", "Swims up."},
      {"movedown", "Swims down; crouches in Half-Life's levels."},
      {"left", "Turns left."},
      {"right", "Turns right."},
      {"lookup", "Looks up."},
      {"lookdown", "Looks down."},
      {"speed", "Runs. Walks if cl_alwaysrun is on."},
      {"strafe", "Turn keys and the mouse strafe."},
      {"attack", "Fires."},
      {"jump", "Jumps, or swims up."},
      {"klook", "Forward and back keys look up and down."},
      {"mlook", "The mouse looks up and down while freelook is off."},
      {"zoom", "Zooms in."},
      {"showscores", "Shows the scores."},
  }};
  return kNames[static_cast<std::size_t>(button)];
}

// A key that joins others only becomes one more holder: the action has begun already.
void ButtonState::press(int holder, double time_s) {
  if (std::find(holders_.begin(), holders_.end(), holder) != holders_.end()) return;
  if (holders_.empty()) counted_to_s_ = pressed_s_ = time_s;
  holders_.push_back(holder);
  was_pressed_ = true;
}

void ButtonState::release(int holder, double time_s) {
  if (holders_.empty()) return;
  if (holder == 0)
    holders_.clear();
  else
    std::erase(holders_, holder);
  if (!holders_.empty()) return;
  held_s_ += std::max(0.0, time_s - counted_to_s_);
  was_tapped_ |= time_s <= pressed_s_;
}

bool ButtonState::take_was_down() {
  return std::exchange(was_pressed_, false) || is_down();
}

// Time is counted up to `time_s`; what follows belongs to the next call.
double ButtonState::take_held_s(double time_s) {
  const double uncounted_s = std::max(0.0, time_s - counted_to_s_);
  if (is_down()) {
    held_s_ += uncounted_s;
    counted_to_s_ = std::max(counted_to_s_, time_s);
  } else if (was_tapped_) {
    held_s_ += uncounted_s / 2;
  }
  was_tapped_ = false;
  return std::exchange(held_s_, 0.0);
}

}  // namespace temblor::client
