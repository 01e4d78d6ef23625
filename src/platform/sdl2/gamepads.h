// Gamepads that come and go; all of them play for the one player.
#pragma once

#include <SDL.h>

#include <map>
#include <memory>
#include <vector>

#include "platform/input_event.h"

namespace temblor::platform::sdl2 {

class Gamepads {
 public:
  // Appends what an SDL event of a gamepad means; nothing for others.
  void take(const SDL_Event& event, double time_s, std::vector<InputEvent>& io_events);
  void rumble(float low, float high, double seconds);

 private:
  struct Close {
    void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
  };
  using Pad = std::unique_ptr<SDL_GameController, Close>;

  void add(int device, double time_s, std::vector<InputEvent>& io_events);
  void remove(SDL_JoystickID id, double time_s, std::vector<InputEvent>& io_events);
  void move(const SDL_ControllerAxisEvent& event, double time_s, std::vector<InputEvent>& io_events);
  void pull_trigger(Key key, bool& io_pulled, float value, double time_s, std::vector<InputEvent>& io_events);

  std::map<SDL_JoystickID, Pad> pads_;
  bool left_trigger_ = false, right_trigger_ = false;
};

}  // namespace temblor::platform::sdl2
