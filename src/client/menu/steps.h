// From keys, buttons and sticks to steps through a menu. What is held on a gamepad is repeated, as a
// keyboard does by itself.
#pragma once

#include <optional>

#include "platform/input_event.h"

namespace temblor::client {

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
  kErase,  // the last letter that was typed, or else as kClear
  kClear,
  kClose,
};

class MenuSteps {
 public:
  static constexpr double kFirstRepeatSeconds = 0.4, kRepeatSeconds = 0.1;

  // The step that an event is, at once.
  std::optional<MenuStep> take(const platform::InputEvent& event);
  // The step that what is held has come to; at most one a call, however much time has passed.
  std::optional<MenuStep> repeated(double time_s);
  void let_go() { held_ = {}; }

 private:
  std::optional<MenuStep> take_key(const platform::KeyChange& change, double time_s);
  std::optional<MenuStep> take_axis(const platform::PadAxisMoved& moved, double time_s);
  void hold(MenuStep step, double time_s);

  struct Held {
    std::optional<MenuStep> step;
    double next_s = 0;
  };
  Held held_;
  float stick_x_ = 0, stick_y_ = 0;
  std::optional<MenuStep> pushed_;  // by the stick
};

}  // namespace temblor::client
