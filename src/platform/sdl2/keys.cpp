#include "platform/sdl2/keys.h"

#include <array>
#include <utility>

namespace temblor::platform::sdl2 {
namespace {

// Keys without a character. Both keys of a pair (left and right Shift) are one key for bindings.
constexpr std::pair<SDL_Scancode, Key> kNamed[] = {
    {SDL_SCANCODE_TAB, Key::kTab},
    {SDL_SCANCODE_RETURN, Key::kEnter},
    {SDL_SCANCODE_ESCAPE, Key::kEscape},
    {SDL_SCANCODE_SPACE, Key::kSpace},
    {SDL_SCANCODE_BACKSPACE, Key::kBackspace},
    {SDL_SCANCODE_UP, Key::kUpArrow},
    {SDL_SCANCODE_DOWN, Key::kDownArrow},
    {SDL_SCANCODE_LEFT, Key::kLeftArrow},
    {SDL_SCANCODE_RIGHT, Key::kRightArrow},
    {SDL_SCANCODE_LALT, Key::kAlt},
    {SDL_SCANCODE_RALT, Key::kAlt},
    {SDL_SCANCODE_LCTRL, Key::kCtrl},
    {SDL_SCANCODE_RCTRL, Key::kCtrl},
    {SDL_SCANCODE_LSHIFT, Key::kShift},
    {SDL_SCANCODE_RSHIFT, Key::kShift},
    {SDL_SCANCODE_LGUI, Key::kCommand},
    {SDL_SCANCODE_RGUI, Key::kCommand},
    {SDL_SCANCODE_CAPSLOCK, Key::kCapsLock},
    {SDL_SCANCODE_F1, Key::kF1},
    {SDL_SCANCODE_F2, Key::kF2},
    {SDL_SCANCODE_F3, Key::kF3},
    {SDL_SCANCODE_F4, Key::kF4},
    {SDL_SCANCODE_F5, Key::kF5},
    {SDL_SCANCODE_F6, Key::kF6},
    {SDL_SCANCODE_F7, Key::kF7},
    {SDL_SCANCODE_F8, Key::kF8},
    {SDL_SCANCODE_F9, Key::kF9},
    {SDL_SCANCODE_F10, Key::kF10},
    {SDL_SCANCODE_F11, Key::kF11},
    {SDL_SCANCODE_F12, Key::kF12},
    {SDL_SCANCODE_INSERT, Key::kInsert},
    {SDL_SCANCODE_DELETE, Key::kDelete},
    {SDL_SCANCODE_PAGEDOWN, Key::kPageDown},
    {SDL_SCANCODE_PAGEUP, Key::kPageUp},
    {SDL_SCANCODE_HOME, Key::kHome},
    {SDL_SCANCODE_END, Key::kEnd},
    {SDL_SCANCODE_PAUSE, Key::kPause},
    {SDL_SCANCODE_PRINTSCREEN, Key::kPrintScreen},
    {SDL_SCANCODE_KP_0, Key::kKeypad0},
    {SDL_SCANCODE_KP_1, Key::kKeypad1},
    {SDL_SCANCODE_KP_2, Key::kKeypad2},
    {SDL_SCANCODE_KP_3, Key::kKeypad3},
    {SDL_SCANCODE_KP_4, Key::kKeypad4},
    {SDL_SCANCODE_KP_5, Key::kKeypad5},
    {SDL_SCANCODE_KP_6, Key::kKeypad6},
    {SDL_SCANCODE_KP_7, Key::kKeypad7},
    {SDL_SCANCODE_KP_8, Key::kKeypad8},
    {SDL_SCANCODE_KP_9, Key::kKeypad9},
    {SDL_SCANCODE_KP_PERIOD, Key::kKeypadPeriod},
    {SDL_SCANCODE_KP_DIVIDE, Key::kKeypadDivide},
    {SDL_SCANCODE_KP_MULTIPLY, Key::kKeypadMultiply},
    {SDL_SCANCODE_KP_MINUS, Key::kKeypadMinus},
    {SDL_SCANCODE_KP_PLUS, Key::kKeypadPlus},
    {SDL_SCANCODE_KP_ENTER, Key::kKeypadEnter},
    {SDL_SCANCODE_MINUS, Key{'-'}},
    {SDL_SCANCODE_EQUALS, Key{'='}},
    {SDL_SCANCODE_LEFTBRACKET, Key{'['}},
    {SDL_SCANCODE_RIGHTBRACKET, Key{']'}},
    {SDL_SCANCODE_BACKSLASH, Key{'\\'}},
    {SDL_SCANCODE_NONUSHASH, Key{'\\'}},
    {SDL_SCANCODE_NONUSBACKSLASH, Key{'<'}},
    {SDL_SCANCODE_SEMICOLON, Key{';'}},
    {SDL_SCANCODE_APOSTROPHE, Key{'\''}},
    {SDL_SCANCODE_GRAVE, Key{'`'}},
    {SDL_SCANCODE_COMMA, Key{','}},
    {SDL_SCANCODE_PERIOD, Key{'.'}},
    {SDL_SCANCODE_SLASH, Key{'/'}},
};

constexpr std::array<Key, SDL_CONTROLLER_BUTTON_MAX> kPadButtons = [] {
  std::array<Key, SDL_CONTROLLER_BUTTON_MAX> keys{};
  keys[SDL_CONTROLLER_BUTTON_A] = Key::kPadA;
  keys[SDL_CONTROLLER_BUTTON_B] = Key::kPadB;
  keys[SDL_CONTROLLER_BUTTON_X] = Key::kPadX;
  keys[SDL_CONTROLLER_BUTTON_Y] = Key::kPadY;
  keys[SDL_CONTROLLER_BUTTON_BACK] = Key::kPadBack;
  keys[SDL_CONTROLLER_BUTTON_GUIDE] = Key::kPadGuide;
  keys[SDL_CONTROLLER_BUTTON_START] = Key::kPadStart;
  keys[SDL_CONTROLLER_BUTTON_LEFTSTICK] = Key::kPadLeftThumb;
  keys[SDL_CONTROLLER_BUTTON_RIGHTSTICK] = Key::kPadRightThumb;
  keys[SDL_CONTROLLER_BUTTON_LEFTSHOULDER] = Key::kPadLeftShoulder;
  keys[SDL_CONTROLLER_BUTTON_RIGHTSHOULDER] = Key::kPadRightShoulder;
  keys[SDL_CONTROLLER_BUTTON_DPAD_UP] = Key::kPadUp;
  keys[SDL_CONTROLLER_BUTTON_DPAD_DOWN] = Key::kPadDown;
  keys[SDL_CONTROLLER_BUTTON_DPAD_LEFT] = Key::kPadLeft;
  keys[SDL_CONTROLLER_BUTTON_DPAD_RIGHT] = Key::kPadRight;
  return keys;
}();

constexpr std::array<Key, SDL_NUM_SCANCODES> kKeyboard = [] {
  std::array<Key, SDL_NUM_SCANCODES> keys{};
  for (int i = 0; i < 26; ++i)
    keys[static_cast<std::size_t>(SDL_SCANCODE_A + i)] = Key(static_cast<std::uint16_t>('a' + i));
  for (int i = 0; i < 9; ++i)
    keys[static_cast<std::size_t>(SDL_SCANCODE_1 + i)] = Key(static_cast<std::uint16_t>('1' + i));
  keys[SDL_SCANCODE_0] = Key{'0'};
  for (const auto& [scancode, key] : kNamed) keys[static_cast<std::size_t>(scancode)] = key;
  return keys;
}();

}  // namespace

Key find_key(SDL_Scancode scancode) {
  const auto index = static_cast<std::size_t>(scancode);
  return index < kKeyboard.size() ? kKeyboard[index] : Key::kNone;
}

Key find_mouse_key(int button) {
  switch (button) {
    case SDL_BUTTON_LEFT:
      return Key::kMouse1;
    case SDL_BUTTON_RIGHT:
      return Key::kMouse2;
    case SDL_BUTTON_MIDDLE:
      return Key::kMouse3;
    case 4:
      return Key::kMouse4;
    case 5:
      return Key::kMouse5;
    case 6:
      return Key::kMouse6;
    case 7:
      return Key::kMouse7;
    case 8:
      return Key::kMouse8;
    default:
      return Key::kNone;
  }
}

Key find_key(SDL_GameControllerButton button) {
  const auto index = static_cast<std::size_t>(button);
  return index < kPadButtons.size() ? kPadButtons[index] : Key::kNone;
}

}  // namespace temblor::platform::sdl2
