#include "client/input/key_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "base/text.h"

namespace temblor::client {
namespace {

using platform::Key;

struct NamedKey {
  std::string_view name;
  Key key;
};

// The first name of a key is the one that is written. Later ones are accepted, too.
constexpr NamedKey kNames[] = {
    {"TAB", Key::kTab},
    {"ENTER", Key::kEnter},
    {"ESCAPE", Key::kEscape},
    {"SPACE", Key::kSpace},
    {"BACKSPACE", Key::kBackspace},
    {"UPARROW", Key::kUpArrow},
    {"DOWNARROW", Key::kDownArrow},
    {"LEFTARROW", Key::kLeftArrow},
    {"RIGHTARROW", Key::kRightArrow},
    {"ALT", Key::kAlt},
    {"CTRL", Key::kCtrl},
    {"SHIFT", Key::kShift},
    {"COMMAND", Key::kCommand},
    {"CAPSLOCK", Key::kCapsLock},
    {"F1", Key::kF1},
    {"F2", Key::kF2},
    {"F3", Key::kF3},
    {"F4", Key::kF4},
    {"F5", Key::kF5},
    {"F6", Key::kF6},
    {"F7", Key::kF7},
    {"F8", Key::kF8},
    {"F9", Key::kF9},
    {"F10", Key::kF10},
    {"F11", Key::kF11},
    {"F12", Key::kF12},
    {"INS", Key::kInsert},
    {"DEL", Key::kDelete},
    {"PGDN", Key::kPageDown},
    {"PGUP", Key::kPageUp},
    {"HOME", Key::kHome},
    {"END", Key::kEnd},
    {"PAUSE", Key::kPause},
    {"PRINTSCREEN", Key::kPrintScreen},
    {"KP_0", Key::kKeypad0},
    {"KP_1", Key::kKeypad1},
    {"KP_2", Key::kKeypad2},
    {"KP_3", Key::kKeypad3},
    {"KP_4", Key::kKeypad4},
    {"KP_5", Key::kKeypad5},
    {"KP_6", Key::kKeypad6},
    {"KP_7", Key::kKeypad7},
    {"KP_8", Key::kKeypad8},
    {"KP_9", Key::kKeypad9},
    {"KP_DEL", Key::kKeypadPeriod},
    {"KP_SLASH", Key::kKeypadDivide},
    {"KP_STAR", Key::kKeypadMultiply},
    {"KP_MINUS", Key::kKeypadMinus},
    {"KP_PLUS", Key::kKeypadPlus},
    {"KP_ENTER", Key::kKeypadEnter},
    {"KP_INS", Key::kKeypad0},
    {"KP_END", Key::kKeypad1},
    {"KP_DOWNARROW", Key::kKeypad2},
    {"KP_PGDN", Key::kKeypad3},
    {"KP_LEFTARROW", Key::kKeypad4},
    {"KP_RIGHTARROW", Key::kKeypad6},
    {"KP_HOME", Key::kKeypad7},
    {"KP_UPARROW", Key::kKeypad8},
    {"KP_PGUP", Key::kKeypad9},
    {"MOUSE1", Key::kMouse1},
    {"MOUSE2", Key::kMouse2},
    {"MOUSE3", Key::kMouse3},
    {"MOUSE4", Key::kMouse4},
    {"MOUSE5", Key::kMouse5},
    {"MOUSE6", Key::kMouse6},
    {"MOUSE7", Key::kMouse7},
    {"MOUSE8", Key::kMouse8},
    {"MWHEELUP", Key::kWheelUp},
    {"MWHEELDOWN", Key::kWheelDown},
    {"ABUTTON", Key::kPadA},
    {"BBUTTON", Key::kPadB},
    {"XBUTTON", Key::kPadX},
    {"YBUTTON", Key::kPadY},
    {"BACK", Key::kPadBack},
    {"GUIDE", Key::kPadGuide},
    {"START", Key::kPadStart},
    {"LTHUMB", Key::kPadLeftThumb},
    {"RTHUMB", Key::kPadRightThumb},
    {"LSHOULDER", Key::kPadLeftShoulder},
    {"RSHOULDER", Key::kPadRightShoulder},
    {"DPAD_UP", Key::kPadUp},
    {"DPAD_DOWN", Key::kPadDown},
    {"DPAD_LEFT", Key::kPadLeft},
    {"DPAD_RIGHT", Key::kPadRight},
    {"LTRIGGER", Key::kPadLeftTrigger},
    {"RTRIGGER", Key::kPadRightTrigger},
    // These characters separate commands and quote words, so they need names.
    {"SEMICOLON", Key{';'}},
    {"QUOTE", Key{'"'}},
};

// Names in config files of DarkPlaces and ezQuake, which are never written.
constexpr NamedKey kForeignNames[] = {
    {"BACKSLASH", Key{'\\'}},
    {"BACKQUOTE", Key{'`'}},
    {"APOSTROPHE", Key{'\''}},
    {"TILDE", Key{'~'}},
    {"LALT", Key::kAlt},
    {"RALT", Key::kAlt},
    {"LCTRL", Key::kCtrl},
    {"RCTRL", Key::kCtrl},
    {"LSHIFT", Key::kShift},
    {"RSHIFT", Key::kShift},
    {"KP_PERIOD", Key::kKeypadPeriod},
    {"KP_DIVIDE", Key::kKeypadDivide},
    {"KP_MULTIPLY", Key::kKeypadMultiply},
    {"X360_A", Key::kPadA},
    {"X360_B", Key::kPadB},
    {"X360_X", Key::kPadX},
    {"X360_Y", Key::kPadY},
    {"X360_BACK", Key::kPadBack},
    {"X360_START", Key::kPadStart},
    {"X360_LEFT_THUMB", Key::kPadLeftThumb},
    {"X360_RIGHT_THUMB", Key::kPadRightThumb},
    {"X360_LEFT_SHOULDER", Key::kPadLeftShoulder},
    {"X360_RIGHT_SHOULDER", Key::kPadRightShoulder},
    {"X360_DPAD_UP", Key::kPadUp},
    {"X360_DPAD_DOWN", Key::kPadDown},
    {"X360_DPAD_LEFT", Key::kPadLeft},
    {"X360_DPAD_RIGHT", Key::kPadRight},
    {"X360_LEFT_TRIGGER", Key::kPadLeftTrigger},
    {"X360_RIGHT_TRIGGER", Key::kPadRightTrigger},
};

// Keys that type one ASCII character are numbered by it.
bool is_character(Key key) {
  return key > Key::kSpace && key < Key::kBackspace;
}

}  // namespace

std::string key_name(Key key) {
  const auto* const named =
      std::find_if(std::begin(kNames), std::end(kNames), [&](const NamedKey& n) { return n.key == key; });
  if (named != std::end(kNames)) return std::string(named->name);
  if (is_character(key)) return std::string(1, static_cast<char>(key));
  return fmt::format("KEY{}", static_cast<int>(key));
}

std::optional<Key> find_key(std::string_view name) {
  if (name.size() == 1) {
    const Key key{static_cast<std::uint16_t>(base::to_lower(name)[0])};
    return is_character(key) ? std::optional(key) : std::nullopt;
  }
  using Names = std::span<const NamedKey>;
  for (const Names names : {Names(kNames), Names(kForeignNames)})
    for (const NamedKey& named : names)
      if (base::equal_ignoring_case(named.name, name)) return named.key;
  return std::nullopt;
}

}  // namespace temblor::client
