// Gamepads that are connected and disconnected at run time. All of them control the same player.
#pragma once

#include <SDL.h>

#include <map>
#include <memory>
#include <vector>

#include "platform/input_event.h"

namespace temblor::platform::sdl2 {

class Gamepads {
 public:
  // Translates a gamepad event of SDL and appends the result. Ignores all other events.
  void take(const SDL_Event& event, double time_s, std::vector<InputEvent>& io_events);
  // See Window::rumble().
  void rumble(float low, float high, double seconds);

 private:
  struct Close {
    void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
  };
  using Pad = std::unique_ptr<SDL_GameController, Close>;

  void add(int device, double time_s, std::vector<InputEvent>& io_events);
  void remove(SDL_JoystickID id, double time_s, std::vector<InputEvent>& io_events);
  void move(const SDL_ControllerAxisEvent& event, double time_s, std::vector<InputEvent>& io_events);
  // Turns an analog trigger into a key that is pressed or released; `io_pulled` is its state.
  void pull_trigger(Key key, bool& io_pulled, float value, double time_s, std::vector<InputEvent>& io_events);

  std::map<SDL_JoystickID, Pad> pads_;
  bool left_trigger_ = false, right_trigger_ = false;
};

}  // namespace temblor::platform::sdl2
