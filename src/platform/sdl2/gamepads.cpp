#include "platform/sdl2/gamepads.h"

#include <algorithm>
#include <optional>

#include "platform/sdl2/keys.h"

namespace temblor::platform::sdl2 {
namespace {

// A trigger is pressed at the first value and released at the second. The difference is a hysteresis, so that
// a trembling finger does not press it again and again.
constexpr float kPressValue = 0.5f, kReleaseValue = 0.4f;

// Returns nothing for the triggers, which act as keys.
std::optional<PadAxis> stick_axis(int axis) {
  switch (axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
      return PadAxis::kLeftX;
    case SDL_CONTROLLER_AXIS_LEFTY:
      return PadAxis::kLeftY;
    case SDL_CONTROLLER_AXIS_RIGHTX:
      return PadAxis::kRightX;
    case SDL_CONTROLLER_AXIS_RIGHTY:
      return PadAxis::kRightY;
    default:
      return std::nullopt;
  }
}

}  // namespace

void Gamepads::take(const SDL_Event& event, double time_s, std::vector<InputEvent>& io_events) {
  switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED:
      return add(event.cdevice.which, time_s, io_events);
    case SDL_CONTROLLERDEVICEREMOVED:
      return remove(event.cdevice.which, time_s, io_events);
    case SDL_CONTROLLERAXISMOTION:
      return move(event.caxis, time_s, io_events);
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      if (const Key key = find_key(static_cast<SDL_GameControllerButton>(event.cbutton.button));
          key != Key::kNone)
        io_events.push_back({time_s, KeyChange{key, event.type == SDL_CONTROLLERBUTTONDOWN}});
      return;
    default:
      return;
  }
}

// SDL also reports devices that were connected before the start. A device may be reported twice: the second
// one is ignored.
void Gamepads::add(int device, double time_s, std::vector<InputEvent>& io_events) {
  Pad pad(SDL_GameControllerOpen(device));
  if (!pad) return;
  const char* const name = SDL_GameControllerName(pad.get());
  const SDL_JoystickID id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad.get()));
  if (!pads_.emplace(id, std::move(pad)).second) return;
  io_events.push_back({time_s, PadChanged{true, name ? name : "gamepad"}});
}

void Gamepads::remove(SDL_JoystickID id, double time_s, std::vector<InputEvent>& io_events) {
  const auto found = pads_.find(id);
  if (found == pads_.end()) return;
  const char* const name = SDL_GameControllerName(found->second.get());
  io_events.push_back({time_s, PadChanged{false, name ? name : "gamepad"}});
  pads_.erase(found);
  // A disconnected gamepad sends no more events. Center its sticks and release its triggers here, so that the
  // player does not keep walking.
  for (std::size_t axis = 0; axis < kPadAxes; ++axis)
    io_events.push_back({time_s, PadAxisMoved{static_cast<PadAxis>(axis), 0}});
  pull_trigger(Key::kPadLeftTrigger, left_trigger_, 0, time_s, io_events);
  pull_trigger(Key::kPadRightTrigger, right_trigger_, 0, time_s, io_events);
}

void Gamepads::move(const SDL_ControllerAxisEvent& event, double time_s, std::vector<InputEvent>& io_events) {
  const float value = std::clamp(static_cast<float>(event.value) / SDL_JOYSTICK_AXIS_MAX, -1.0f, 1.0f);
  if (const std::optional<PadAxis> axis = stick_axis(event.axis))
    io_events.push_back({time_s, PadAxisMoved{*axis, value}});
  else if (event.axis == SDL_CONTROLLER_AXIS_TRIGGERLEFT)
    pull_trigger(Key::kPadLeftTrigger, left_trigger_, value, time_s, io_events);
  else if (event.axis == SDL_CONTROLLER_AXIS_TRIGGERRIGHT)
    pull_trigger(Key::kPadRightTrigger, right_trigger_, value, time_s, io_events);
}

void Gamepads::pull_trigger(Key key, bool& io_pulled, float value, double time_s,
                            std::vector<InputEvent>& io_events) {
  const bool pulled = value > (io_pulled ? kReleaseValue : kPressValue);
  if (pulled == io_pulled) return;
  io_pulled = pulled;
  io_events.push_back({time_s, KeyChange{key, pulled}});
}

void Gamepads::rumble(float low, float high, double seconds) {
  const auto strength = [](float part) {
    return static_cast<Uint16>(std::clamp(part, 0.0f, 1.0f) * 65535.0f);
  };
  const auto duration_ms = static_cast<Uint32>(std::clamp(seconds, 0.0, 10.0) * 1000.0);
  // All gamepads control one player. SDL ignores the call for gamepads without motors.
  for (const auto& [id, pad] : pads_)
    SDL_GameControllerRumble(pad.get(), strength(low), strength(high), duration_ms);
}

}  // namespace temblor::platform::sdl2
