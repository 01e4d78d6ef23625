// The actions that last: +forward, +attack and so on.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace temblor::client {

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
// Without the '+', and one sentence.
struct ButtonName {
  std::string_view name, help;
};
ButtonName name_of(Button button);

// One action, held by any number of keys. Exact to the moment: what it adds up to does not depend on how
// often it is asked.
class ButtonState {
 public:
  // `holder`: a key's number; 0: typed.
  void press(int holder, double time_s);
  // 0 lets all of them go, for a typed "-forward" must end what has stuck.
  void release(int holder, double time_s);

  bool is_down() const { return !holders_.empty(); }
  // Whether it was held at all since the last call: a press and release between two calls is not lost.
  bool take_was_down();
  // Seconds that it was held between the last call and this moment.
  double take_held_s(double time_s);

 private:
  std::vector<int> holders_;
  bool was_pressed_ = false;
  double counted_to_s_ = 0;  // while down
  double held_s_ = 0;        // not taken yet
};

class Buttons {
 public:
  ButtonState& operator[](Button button) { return states_[static_cast<std::size_t>(button)]; }
  const ButtonState& operator[](Button button) const { return states_[static_cast<std::size_t>(button)]; }

 private:
  std::array<ButtonState, kButtons> states_;
};

}  // namespace temblor::client
