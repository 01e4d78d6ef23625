// What the player does, and what happens to the window.
#pragma once

#include <string>
#include <variant>

#include "platform/key.h"

namespace temblor::platform {

struct KeyChange {
  Key key = Key::kNone;
  bool down = false;
  bool repeated = false;  // held long enough for another one: for typing, not for playing
};
// What a key, or several, have typed: UTF-8, without control characters. Comes behind the KeyChange. Only
// while the window takes text.
struct TextTyped {
  std::string text;
};
// How far the mouse was moved, in its own counts, right and down positive. Only while it is captured.
struct MouseMoved {
  float right = 0, down = 0;
};
// Where the pointer is: 0, 0 is the window's upper left corner, 1, 1 the lower right one. Only while the
// mouse is not captured.
struct PointerMoved {
  float x = 0, y = 0;
};
// As the stick says, -1 to 1, right and down positive.
struct PadAxisMoved {
  PadAxis axis{};
  float value = 0;
};
struct PadChanged {
  bool connected = false;
  std::string name;
};
// Without the focus nothing of the keyboard arrives: whatever was held counts as released.
struct FocusChanged {
  bool focused = false;
};
// The window's size is another one, or it has moved to another display.
struct WindowChanged {
  int width = 0, height = 0;  // as WindowSettings::size; Window::size() says it in pixels
};
// The window's close button, or the system is going down.
struct CloseRequested {};

struct InputEvent {
  double time_s = 0;  // when it happened, on Window::now_s()'s clock
  std::variant<KeyChange, TextTyped, MouseMoved, PointerMoved, PadAxisMoved, PadChanged, FocusChanged,
               WindowChanged, CloseRequested>
      what;
};

}  // namespace temblor::platform
