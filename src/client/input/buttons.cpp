#include "client/input/buttons.h"

#include <algorithm>
#include <utility>

namespace temblor::client {

ButtonName name_of(Button button) {
  static constexpr std::array<ButtonName, kButtons> kNames = {{
      {"forward", "Walks ahead."},
      {"back", "Walks backwards."},
      {"moveleft", "Steps to the left."},
      {"moveright", "Steps to the right."},
      {"moveup", "Swims up."},
      {"movedown", "Swims down."},
      {"left", "Turns left."},
      {"right", "Turns right."},
      {"lookup", "Looks up."},
      {"lookdown", "Looks down."},
      {"speed", "Runs; with cl_alwaysrun: walks."},
      {"strafe", "Turning keys and the mouse step aside instead."},
      {"attack", "Fires."},
      {"jump", "Jumps; swims up."},
      {"klook", "Keys that walk ahead and back look up and down instead."},
      {"mlook", "The mouse looks up and down, where freelook is off."},
      {"zoom", "Narrows the view to zoom_fov."},
      {"showscores", "Shows the scores."},
  }};
  return kNames[static_cast<std::size_t>(button)];
}

void ButtonState::press(int holder, double time_s) {
  if (std::find(holders_.begin(), holders_.end(), holder) != holders_.end()) return;
  if (holders_.empty()) counted_to_s_ = time_s;
  holders_.push_back(holder);
  was_pressed_ = true;
}

void ButtonState::release(int holder, double time_s) {
  if (holders_.empty()) return;
  if (holder == 0)
    holders_.clear();
  else
    std::erase(holders_, holder);
  if (holders_.empty()) held_s_ += std::max(0.0, time_s - counted_to_s_);
}

bool ButtonState::take_was_down() {
  return std::exchange(was_pressed_, false) || is_down();
}

double ButtonState::take_held_s(double time_s) {
  if (is_down() && time_s > counted_to_s_) {
    held_s_ += time_s - counted_to_s_;
    counted_to_s_ = time_s;
  }
  return std::exchange(held_s_, 0.0);
}

}  // namespace temblor::client
