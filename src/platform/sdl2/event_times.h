// When the events of keyboard and mouse happened.
//
// SDL stamps an event when it reads it, once a frame. The X server stamps it when it happens, in milliseconds
// on the clock CLOCK_MONOTONIC. SDL passes on each event of the X server before the events that it makes of
// it:
//
//   SDL_SYSWMEVENT (X: time)   SDL_KEYDOWN   SDL_TEXTINPUT   SDL_SYSWMEVENT (X: time)   SDL_KEYUP
//
// Without an X server, and for relative mouse movement, whose X events have no time that SDL passes on,
// events happen when they are read.
#pragma once

#include <cstdint>
#include <optional>

union SDL_Event;

namespace temblor::platform::sdl2 {

class EventTimes {
 public:
  // Asks SDL for the events of the X server.
  EventTimes();

  // Takes an event that SDL has returned at `now_s`. Returns when it happened, on the clock of `now_s`.
  double take(const SDL_Event& event, double now_s);

 private:
  // The time of the last event of the X server; nothing if it has none.
  std::optional<std::uint32_t> server_time_ms_;
};

// Returns how long ago the server's time was, in seconds. Both times are in milliseconds and wrap around.
// Returns 0 if it is not within the last second: then the server has another clock.
double compute_age_s(std::uint32_t server_time_ms, std::uint32_t now_ms);

}  // namespace temblor::platform::sdl2
