// When the events of keyboard and mouse happened.
//
// SDL stamps an event when it reads it, once a frame. The X server stamps it when it happens, in milliseconds
// on the clock CLOCK_MONOTONIC. SDL passes on each event of the X server before the events that it makes of
// it:
//
//   SDL_SYSWMEVENT (X: time)   SDL_KEYDOWN   SDL_TEXTINPUT   SDL_SYSWMEVENT (X: time)   SDL_KEYUP
//
// Relative movement is different: SDL sends its own event before X's (Debian 12; others may send it after),
// and frees X's data, with the time, before the program gets either. So both are watched while SDL sends
// them, and the times are kept until the program takes the movement.
//
// SDL 2 reads Wayland's events without their times, so wayland_times.h reads them again.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "platform/sdl2/events/wayland_times.h"

struct SDL_Window;
union SDL_Event;

namespace temblor::platform::sdl2 {

class EventTimes {
 public:
  // Asks SDL for the events of the X server, or the window's Wayland display for its own. Must be destroyed
  // before the window.
  explicit EventTimes(SDL_Window* window);
  ~EventTimes();
  EventTimes(const EventTimes&) = delete;
  EventTimes& operator=(const EventTimes&) = delete;

  // Takes an event that SDL has returned at `now_s`. Returns when it happened, on the clock of `now_s`.
  double take(const SDL_Event& event, double now_s);
  // Call it when SDL has returned all its events.
  void end_poll();

 private:
  // Called by SDL while it sends an event. `self` is this object.
  static int watch(void* self, SDL_Event* event);
  void watch_movement(const SDL_Event& event);
  void watch_raw_movement(std::uint32_t server_time_ms);
  std::optional<std::uint32_t> take_movement_time(const SDL_Event& event);
  std::optional<std::uint32_t> take_server_time(const SDL_Event& event);
  std::optional<std::uint32_t> take_wayland_time(const SDL_Event& event);

  // Null on other displays.
  std::unique_ptr<WaylandTimes> wayland_;
  // The time of the display's last event; nothing if it has none.
  std::optional<std::uint32_t> server_time_ms_;
  // Relative movement that SDL has sent and the program has not taken.
  struct Movement {
    int right = 0, down = 0;
    std::uint32_t sdl_time_ms = 0;
    std::optional<std::uint32_t> server_time_ms;
  };
  std::deque<Movement> movements_;
  // The time of an event of X before the one that SDL makes of it, and that of the last movement.
  std::optional<std::uint32_t> next_time_ms_, last_time_ms_;
};

// Returns how long ago the server's time was, in seconds. Both times are in milliseconds and wrap around.
// Returns nothing if it is not within the last second: then the server has another clock.
std::optional<double> compute_age_s(std::uint32_t server_time_ms, std::uint32_t now_ms);

}  // namespace temblor::platform::sdl2
