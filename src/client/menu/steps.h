// Translates keys, gamepad buttons and sticks to steps through a menu. Keyboards repeat held keys on their
// own; this class repeats what is held on a gamepad.
#pragma once

#include <optional>

#include "platform/input_event.h"

namespace temblor::client {

// Steps up to kPageDown, and kErase, repeat while held.
enum class MenuStep {
  kUp,
  kDown,
  kLeft,
  kRight,
  kPageUp,
  kPageDown,
  kHome,
  kEnd,
  kAccept,
  kBack,
  kErase,  // deletes the last letter typed; without one acts as kClear
  kClear,
  kClose,
};

class MenuSteps {
 public:
  static constexpr double kFirstRepeatSeconds = 0.4, kRepeatSeconds = 0.1;

  // Returns the step that an event means; nothing for other events.
  std::optional<MenuStep> translate(const platform::InputEvent& event);
  // Returns the step that a held button or stick repeats at this time. At most one step per call, however
  // much time has passed.
  std::optional<MenuStep> repeat_held(double time_s);
  void release() { held_ = {}; }

 private:
  std::optional<MenuStep> handle_key(const platform::KeyChange& change, double time_s);
  std::optional<MenuStep> handle_axis(const platform::PadAxisMoved& moved, double time_s);
  void hold(MenuStep step, double time_s);

  struct Held {
    std::optional<MenuStep> step;
    double next_s = 0;  // when it repeats
  };
  Held held_;
  float stick_x_ = 0, stick_y_ = 0;  // -1 to 1
  // The step that the stick has made. It must return to its center before it makes another.
  std::optional<MenuStep> pushed_;
};

}  // namespace temblor::client
