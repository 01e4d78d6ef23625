#include "platform/sdl2/event_times.h"

#include <SDL_events.h>
#include <SDL_syswm.h>

#include <chrono>

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

std::uint32_t monotonic_ms() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

}  // namespace

EventTimes::EventTimes() {
  SDL_EventState(SDL_SYSWMEVENT, SDL_ENABLE);
}

double EventTimes::take(const SDL_Event& event, double now_s) {
  if (event.type == SDL_SYSWMEVENT) server_time_ms_ = find_server_time_ms(event.syswm);
  if (!server_time_ms_ || !is_of_keyboard_or_mouse(event.type)) return now_s;
  return now_s - compute_age_s(*server_time_ms_, monotonic_ms());
}

double compute_age_s(std::uint32_t server_time_ms, std::uint32_t now_ms) {
  constexpr std::uint32_t kMaxAge_ms = 1000;
  const std::uint32_t age_ms = now_ms - server_time_ms;
  return age_ms <= kMaxAge_ms ? age_ms / 1000.0 : 0;
}

}  // namespace temblor::platform::sdl2
