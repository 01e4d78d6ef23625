// Keys, buttons and sticks that commands can be bound to.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::platform {

// Values 33 to 126 are the character that a US keyboard has at the key's place, without Shift: bindings go by
// where keys are, so that hands find them on every layout. Names are given to the rest.
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
  // Of a gamepad, by where they are: A is the lower one of the four.
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
  kPadLeftTrigger,  // pulled half way
  kPadRightTrigger,
  kCount
};
constexpr std::size_t kKeys = static_cast<std::size_t>(Key::kCount);

enum class PadAxis : std::uint8_t { kLeftX, kLeftY, kRightX, kRightY, kCount };
constexpr std::size_t kPadAxes = static_cast<std::size_t>(PadAxis::kCount);

}  // namespace temblor::platform
