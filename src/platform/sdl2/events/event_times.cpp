#include "platform/sdl2/events/event_times.h"

#include <SDL_events.h>
#include <SDL_mouse.h>
#include <SDL_syswm.h>
#ifdef SDL_VIDEO_DRIVER_X11
#include <X11/extensions/XInput2.h>
#endif

#include <chrono>
#include <utility>

namespace temblor::platform::sdl2 {
namespace {

std::optional<std::uint32_t> find_server_time_ms(const SDL_SysWMEvent& event) {
#ifdef SDL_VIDEO_DRIVER_X11
  if (event.msg->subsystem != SDL_SYSWM_X11) return std::nullopt;
  const XEvent& x = event.msg->msg.x11.event;
  switch (x.type) {
    case KeyPress:
    case KeyRelease:
      return static_cast<std::uint32_t>(x.xkey.time);
    case ButtonPress:
    case ButtonRelease:
      return static_cast<std::uint32_t>(x.xbutton.time);
    case MotionNotify:
      return static_cast<std::uint32_t>(x.xmotion.time);
    default:
      return std::nullopt;
  }
#else
  return std::nullopt;
#endif
}

bool is_of_keyboard_or_mouse(std::uint32_t type) {
  return type >= SDL_KEYDOWN && type < SDL_JOYAXISMOTION;
}

template <typename Clock>
std::uint32_t now_ms() {
  const auto now = Clock::now().time_since_epoch();
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

wl_display* find_wayland_display(SDL_Window* window) {
#ifdef SDL_VIDEO_DRIVER_WAYLAND
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(window, &info) == SDL_TRUE && info.subsystem == SDL_SYSWM_WAYLAND)
    return info.info.wl.display;
#endif
  return nullptr;
}

std::optional<WaylandTimes::Kind> find_wayland_kind(const SDL_Event& event) {
  using enum WaylandTimes::Kind;
  switch (event.type) {
    case SDL_KEYDOWN:
      // SDL repeats keys itself.
      return event.key.repeat != 0 ? std::optional<WaylandTimes::Kind>() : kKeyDown;
    case SDL_KEYUP:
      return kKeyUp;
    case SDL_MOUSEBUTTONDOWN:
      return kButtonDown;
    case SDL_MOUSEBUTTONUP:
      return kButtonUp;
    case SDL_MOUSEWHEEL:
      return kWheel;
    case SDL_MOUSEMOTION:
      return SDL_GetRelativeMouseMode() == SDL_TRUE ? kRelativeMove : kMove;
    default:
      return std::nullopt;
  }
}

}  // namespace

EventTimes::EventTimes(SDL_Window* window) {
  if (wl_display* const display = find_wayland_display(window))
    wayland_ = std::make_unique<WaylandTimes>(display);
  SDL_EventState(SDL_SYSWMEVENT, SDL_ENABLE);
  SDL_AddEventWatch(watch, this);
}

EventTimes::~EventTimes() {
  SDL_DelEventWatch(watch, this);
}

// Other threads of SDL send other events, so this changes the object only for those of the display.
int EventTimes::watch(void* self, SDL_Event* event) {
  EventTimes& times = *static_cast<EventTimes*>(self);
  if (event->type == SDL_MOUSEMOTION) times.watch_movement(*event);
#ifdef SDL_VIDEO_DRIVER_X11
  if (event->type != SDL_SYSWMEVENT || event->syswm.msg->subsystem != SDL_SYSWM_X11) return 0;
  const XEvent& x = event->syswm.msg->msg.x11.event;
  // SDL asks for generic events of XInput 2 only.
  if (x.type == GenericEvent && x.xcookie.evtype == XI_RawMotion && x.xcookie.data != nullptr)
    times.watch_raw_movement(
        static_cast<std::uint32_t>(static_cast<const XIRawEvent*>(x.xcookie.data)->time));
#endif
  return 0;
}

void EventTimes::watch_movement(const SDL_Event& event) {
  if (SDL_GetRelativeMouseMode() == SDL_FALSE) return;
  movements_.push_back(
      {event.motion.xrel, event.motion.yrel, event.motion.timestamp, std::exchange(next_time_ms_, {})});
  if (movements_.back().server_time_ms) last_time_ms_ = movements_.back().server_time_ms;
}

// X sends each event twice, with the same time: for the mouse, and for the pointer that all mice share. SDL
// ignores the second.
void EventTimes::watch_raw_movement(std::uint32_t server_time_ms) {
  if (SDL_GetRelativeMouseMode() == SDL_FALSE) return;
  if (!movements_.empty() && !movements_.back().server_time_ms) {
    movements_.back().server_time_ms = last_time_ms_ = server_time_ms;
  } else if (last_time_ms_ != server_time_ms) {
    next_time_ms_ = server_time_ms;
  }
}

// The program may have dropped earlier movements.
std::optional<std::uint32_t> EventTimes::take_movement_time(const SDL_Event& event) {
  while (!movements_.empty()) {
    const Movement movement = movements_.front();
    movements_.pop_front();
    if (movement.right == event.motion.xrel && movement.down == event.motion.yrel &&
        movement.sdl_time_ms == event.motion.timestamp)
      return movement.server_time_ms;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> EventTimes::take_server_time(const SDL_Event& event) {
  if (event.type == SDL_SYSWMEVENT) server_time_ms_ = find_server_time_ms(event.syswm);
  const bool is_relative = event.type == SDL_MOUSEMOTION && SDL_GetRelativeMouseMode() == SDL_TRUE;
  return is_relative ? take_movement_time(event) : server_time_ms_;
}

// Text has the time of the key before it.
std::optional<std::uint32_t> EventTimes::take_wayland_time(const SDL_Event& event) {
  if (event.type == SDL_TEXTINPUT) return server_time_ms_;
  const std::optional<WaylandTimes::Kind> kind = find_wayland_kind(event);
  server_time_ms_ = kind ? wayland_->take(*kind) : std::nullopt;
  return server_time_ms_;
}

// Wayland leaves the clock open. Displays with hardware use CLOCK_MONOTONIC; Weston in a window of another
// display uses the time of day.
double EventTimes::take(const SDL_Event& event, double now_s) {
  const std::optional<std::uint32_t> time_ms = wayland_ ? take_wayland_time(event) : take_server_time(event);
  if (!time_ms || !is_of_keyboard_or_mouse(event.type)) return now_s;
  std::optional<double> age_s = compute_age_s(*time_ms, now_ms<std::chrono::steady_clock>());
  if (!age_s && wayland_) age_s = compute_age_s(*time_ms, now_ms<std::chrono::system_clock>());
  return now_s - age_s.value_or(0);
}

void EventTimes::end_poll() {
  if (wayland_) wayland_->clear();
}

std::optional<double> compute_age_s(std::uint32_t server_time_ms, std::uint32_t now_ms) {
  constexpr std::uint32_t kMaxAge_ms = 1000;
  const std::uint32_t age_ms = now_ms - server_time_ms;
  return age_ms <= kMaxAge_ms ? std::optional<double>(age_ms / 1000.0) : std::nullopt;
}

}  // namespace temblor::platform::sdl2
