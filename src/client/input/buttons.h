// Actions that last while a key is held: +forward, +attack and so on (the original's kbutton_t).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace temblor::client {

// In the order of the names in button_name().
enum class Button : std::uint8_t {
  kForward,
  kBack,
  kMoveLeft,
  kMoveRight,
  kMoveUp,
  kMoveDown,
  kTurnLeft,
  kTurnRight,
  kLookUp,
  kLookDown,
  kSpeed,
  kStrafe,
  kAttack,
  kJump,
  kKeyLook,
  kMouseLook,
  kZoom,
  kScores,
  kCount
};
constexpr std::size_t kButtons = static_cast<std::size_t>(Button::kCount);
// The command's name without '+', and its help.
struct ButtonName {
  std::string_view name, help;
};
ButtonName button_name(Button button);

// One action, held by any number of keys. It adds up how long it was held between the times of the key
// events, so the total does not depend on how often it is read. A press and release at the same time are a
// tap of unknown length, which counts half of the time until the next take_held_s().
class ButtonState {
 public:
  // A key or a typed command starts the action. `holder`: the key's number; 0 for a typed command. Does
  // nothing if this holder holds it already. `time_s`: the time of the event, on the window's clock.
  void press(int holder, double time_s);
  // A holder lets go; the action ends with the last one. Holder 0 releases all keys, as a typed "-forward"
  // must end whatever is stuck.
  void release(int holder, double time_s);

  bool is_down() const { return !holders_.empty(); }
  // Whether the action was held at any time since the last call, so that a press and release between two
  // calls is not lost.
  bool take_was_down();
  // Seconds that it was held between the last call and `time_s`.
  double take_held_s(double time_s);

 private:
  std::vector<int> holders_;
  bool was_pressed_ = false;
  bool was_tapped_ = false;  // since take_held_s()
  // Up to when held_s_ counts; valid while down, or after a tap.
  double counted_to_s_ = 0;
  double pressed_s_ = 0;
  // Seconds not yet returned by take_held_s().
  double held_s_ = 0;
};

// The state of each action.
class Buttons {
 public:
  ButtonState& operator[](Button button) { return states_[static_cast<std::size_t>(button)]; }
  const ButtonState& operator[](Button button) const { return states_[static_cast<std::size_t>(button)]; }

 private:
  std::array<ButtonState, kButtons> states_;
};

}  // namespace temblor::client
