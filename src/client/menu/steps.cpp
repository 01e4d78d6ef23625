#include "client/menu/steps.h"

#include <cmath>

namespace temblor::client {
namespace {

using platform::Key;

std::optional<MenuStep> find_step(Key key) {
  switch (key) {
    case Key::kUpArrow:
    case Key::kPadUp:
      return MenuStep::kUp;
    case Key::kDownArrow:
    case Key::kPadDown:
    case Key::kTab:
      return MenuStep::kDown;
    case Key::kLeftArrow:
    case Key::kPadLeft:
      return MenuStep::kLeft;
    case Key::kRightArrow:
    case Key::kPadRight:
      return MenuStep::kRight;
    case Key::kPageUp:
    case Key::kPadLeftShoulder:
      return MenuStep::kPageUp;
    case Key::kPageDown:
    case Key::kPadRightShoulder:
      return MenuStep::kPageDown;
    case Key::kHome:
      return MenuStep::kHome;
    case Key::kEnd:
      return MenuStep::kEnd;
    case Key::kEnter:
    case Key::kKeypadEnter:
    case Key::kPadA:
      return MenuStep::kAccept;
    case Key::kEscape:
    case Key::kPadB:
    case Key::kMouse2:
      return MenuStep::kBack;
    case Key::kBackspace:
      return MenuStep::kErase;
    case Key::kDelete:
    case Key::kPadX:
      return MenuStep::kClear;
    case Key::kPadStart:
      return MenuStep::kClose;
    default:
      return std::nullopt;
  }
}

// Steps that a held key repeats: moves, changes of a value, and deletion.
bool may_repeat(MenuStep step) {
  return step <= MenuStep::kPageDown || step == MenuStep::kErase;
}

}  // namespace

// Forgets held keys when their releases may not arrive.
std::optional<MenuStep> MenuSteps::translate(const platform::InputEvent& event) {
  if (const auto* const change = std::get_if<platform::KeyChange>(&event.what))
    return handle_key(*change, event.time_s);
  if (const auto* const moved = std::get_if<platform::PadAxisMoved>(&event.what))
    return handle_axis(*moved, event.time_s);
  const bool is_lost = std::holds_alternative<platform::FocusChanged>(event.what) ||
                       std::holds_alternative<platform::PadChanged>(event.what);
  if (is_lost) *this = {};
  return std::nullopt;
}

std::optional<MenuStep> MenuSteps::handle_key(const platform::KeyChange& change, double time_s) {
  const std::optional<MenuStep> step = find_step(change.key);
  if (!step) return std::nullopt;
  const bool is_pad = change.key >= Key::kPadA;
  if (!change.down) {
    if (is_pad && held_.step == step) release();
    return std::nullopt;
  }
  if (change.repeated) return may_repeat(*step) ? step : std::nullopt;
  release();
  if (is_pad && may_repeat(*step)) hold(*step, time_s);
  return step;
}

std::optional<MenuStep> MenuSteps::handle_axis(const platform::PadAxisMoved& moved, double time_s) {
  // Hysteresis: a stick that trembles at the threshold makes one step only.
  constexpr float kPushed = 0.6f, kReleased = 0.4f;
  if (!std::isfinite(moved.value)) return std::nullopt;
  if (moved.axis == platform::PadAxis::kLeftX)
    stick_x_ = moved.value;
  else if (moved.axis == platform::PadAxis::kLeftY)
    stick_y_ = moved.value;
  else
    return std::nullopt;
  const float deflection = std::max(std::abs(stick_x_), std::abs(stick_y_));
  if (deflection < kReleased && pushed_) {
    if (held_.step == pushed_) release();
    pushed_.reset();
  }
  if (deflection < kPushed || pushed_) return std::nullopt;
  if (std::abs(stick_x_) > std::abs(stick_y_))
    pushed_ = stick_x_ > 0 ? MenuStep::kRight : MenuStep::kLeft;
  else
    pushed_ = stick_y_ > 0 ? MenuStep::kDown : MenuStep::kUp;
  hold(*pushed_, time_s);
  return pushed_;
}

void MenuSteps::hold(MenuStep step, double time_s) {
  held_ = {step, time_s + kFirstRepeatSeconds};
}

std::optional<MenuStep> MenuSteps::repeat_held(double time_s) {
  if (!held_.step || !(time_s >= held_.next_s)) return std::nullopt;
  held_.next_s = time_s + kRepeatSeconds;
  return held_.step;
}

}  // namespace temblor::client
