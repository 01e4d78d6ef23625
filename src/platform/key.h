// Keys, mouse buttons, gamepad buttons and stick axes. Commands are bound to them (client/input/bindings.h).
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::platform {

// A key's position. Values 33 to 126 are the character that a US keyboard has at that position, without
// Shift, so that WASD stays in the same place on every layout. The other keys have names here.
enum class Key : std::uint16_t {
  kNone = 0,
  kTab = 9,
  kEnter = 13,
  kEscape = 27,
  kSpace = 32,
  kBackspace = 127,
  kUpArrow,
  kDownArrow,
  kLeftArrow,
  kRightArrow,
  kAlt,
  kCtrl,
  kShift,
  kCommand,
  kCapsLock,
  kF1,
  kF2,
  kF3,
  kF4,
  kF5,
  kF6,
  kF7,
  kF8,
  kF9,
  kF10,
  kF11,
  kF12,
  kInsert,
  kDelete,
  kPageDown,
  kPageUp,
  kHome,
  kEnd,
  kPause,
  kPrintScreen,
  kKeypad0,
  kKeypad1,
  kKeypad2,
  kKeypad3,
  kKeypad4,
  kKeypad5,
  kKeypad6,
  kKeypad7,
  kKeypad8,
  kKeypad9,
  kKeypadPeriod,
  kKeypadDivide,
  kKeypadMultiply,
  kKeypadMinus,
  kKeypadPlus,
  kKeypadEnter,
  kMouse1,  // left
  kMouse2,  // right
  kMouse3,  // middle
  kMouse4,
  kMouse5,
  kMouse6,
  kMouse7,
  kMouse8,
  kWheelUp,
  kWheelDown,
  // Gamepad buttons by position: A is the lowest of the four face buttons.
  kPadA,
  kPadB,
  kPadX,
  kPadY,
  kPadBack,
  kPadGuide,
  kPadStart,
  kPadLeftThumb,
  kPadRightThumb,
  kPadLeftShoulder,
  kPadRightShoulder,
  kPadUp,
  kPadDown,
  kPadLeft,
  kPadRight,
  kPadLeftTrigger,  // an analog trigger counts as pressed when it is pulled half way
  kPadRightTrigger,
  kCount
};
constexpr std::size_t kKeys = static_cast<std::size_t>(Key::kCount);

// The sticks of a gamepad.
enum class PadAxis : std::uint8_t { kLeftX, kLeftY, kRightX, kRightY, kCount };
constexpr std::size_t kPadAxes = static_cast<std::size_t>(PadAxis::kCount);

}  // namespace temblor::platform
