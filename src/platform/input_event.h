// Input events: keys, text, mouse, gamepads, and changes of the window. Window::poll() returns them in the
// order in which they happened.
#pragma once

#include <string>
#include <variant>

#include "platform/key.h"

namespace temblor::platform {

// A key or button was pressed or released.
struct KeyChange {
  Key key = Key::kNone;
  bool down = false;
  bool repeated = false;  // the keyboard's auto-repeat: useful for typing, ignored in the game
};
// Text from one or more keys, in UTF-8 without control characters. It follows the KeyChange that caused it.
// Only sent while the window takes text.
struct TextTyped {
  std::string text;
};
// Relative mouse movement in counts of the mouse, right and down positive. Only sent while the mouse is
// captured.
struct MouseMoved {
  float right = 0, down = 0;
};
// The pointer's position: (0, 0) is the window's upper left corner, (1, 1) the lower right one. Only sent
// while the mouse is not captured.
struct PointerMoved {
  float x = 0, y = 0;
};
// The position of one axis of a stick, -1 to 1, right and down positive, without a dead zone.
struct PadAxisMoved {
  PadAxis axis{};
  float value = 0;
};
// A gamepad was connected or disconnected.
struct PadChanged {
  bool connected = false;
  std::string name;
};
// The window got or lost the keyboard. No key arrives without the focus, so the receiver must treat all held
// keys as released.
struct FocusChanged {
  bool focused = false;
};
// The window was resized or moved to another display.
struct WindowChanged {
  int width = 0, height = 0;  // in the units of WindowSettings::size; Window::size() is in pixels
};
// The player clicked the close button, or the system is shutting down.
struct CloseRequested {};

struct InputEvent {
  double time_s = 0;  // when it happened, on the clock of Window::now_s()
  std::variant<KeyChange, TextTyped, MouseMoved, PointerMoved, PadAxisMoved, PadChanged, FocusChanged,
               WindowChanged, CloseRequested>
      what;
};

}  // namespace temblor::platform
