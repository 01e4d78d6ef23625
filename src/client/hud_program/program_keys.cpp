// Numbers of keys in HUD programs. Other engines number keys beyond ASCII alike, except mouse and keypad, for
// which these are the ones that HUD programs are written for.
#include "client/hud_program/program_call.h"

namespace temblor::client {
namespace {

using platform::Key;

struct KeyRange {
  Key first, last;
  int number;  // of the first; the others follow
};
constexpr KeyRange kRanges[] = {
    {Key::kUpArrow, Key::kShift, 128},  // arrows, ALT, CTRL, SHIFT
    {Key::kF1, Key::kF12, 135},
    {Key::kInsert, Key::kEnd, 147},
    {Key::kPause, Key::kPause, 153},
    {Key::kCapsLock, Key::kCapsLock, 155},
    {Key::kPrintScreen, Key::kPrintScreen, 174},
    {Key::kKeypad0, Key::kKeypadEnter, 157},
    {Key::kMouse1, Key::kMouse3, 512},
    {Key::kWheelUp, Key::kWheelDown, 515},
    {Key::kMouse4, Key::kMouse8, 517},
    {Key::kPadA, Key::kPadRightTrigger, 768},
};

}  // namespace

int program_key(platform::Key key) {
  const int value = static_cast<int>(key);
  if (value <= static_cast<int>(Key::kBackspace)) return value;
  for (const KeyRange& range : kRanges)
    if (key >= range.first && key <= range.last) return range.number + value - static_cast<int>(range.first);
  return 0;
}

platform::Key key_of_program(int number) {
  if (number > 0 && number <= static_cast<int>(Key::kBackspace)) return static_cast<Key>(number);
  for (const KeyRange& range : kRanges) {
    const int offset = number - range.number;
    if (offset >= 0 && offset <= static_cast<int>(range.last) - static_cast<int>(range.first))
      return static_cast<Key>(static_cast<int>(range.first) + offset);
  }
  return Key::kNone;
}

}  // namespace temblor::client
