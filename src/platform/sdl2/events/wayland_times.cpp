#include "platform/sdl2/events/wayland_times.h"

#include <unistd.h>
#include <wayland-client.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace temblor::platform::sdl2 {
namespace {

// The protocol extension relative-pointer-unstable-v1, which libwayland does not describe: the manager's
// requests are destroy and get_relative_pointer; a relative pointer has the request destroy and one event.
constexpr std::uint32_t kDestroy = 0, kGetRelativePointer = 1;
constexpr std::string_view kManagerName = "zwp_relative_pointer_manager_v1";

const wl_message kDestroyRequest = {"destroy", "", nullptr};
const std::array<const wl_interface*, 6> kNoTypes = {};
const wl_message kMovementEvent = {"relative_motion", "uuffff",
                                   const_cast<const wl_interface**>(kNoTypes.data())};
const wl_interface kMovementInterface = {"zwp_relative_pointer_v1", 1, 1,
                                         &kDestroyRequest,          1, &kMovementEvent};
const std::array<const wl_interface*, 2> kMovementTypes = {&kMovementInterface, &wl_pointer_interface};
const std::array<wl_message, 2> kManagerRequests = {
    {kDestroyRequest,
     {"get_relative_pointer", "no", const_cast<const wl_interface**>(kMovementTypes.data())}}};
const wl_interface kManagerInterface = {kManagerName.data(), 1, 2, kManagerRequests.data(), 0, nullptr};

// The only event. Its time is in microseconds, in two halves. The second pair of distances is without
// acceleration.
struct MovementListener {
  void (*move)(void* data, wl_proxy*, std::uint32_t time_high, std::uint32_t time_low, wl_fixed_t right,
               wl_fixed_t down, wl_fixed_t, wl_fixed_t);
};

void destroy_extension(wl_proxy* proxy) {
  if (proxy == nullptr) return;
  wl_proxy_marshal_flags(proxy, kDestroy, nullptr, wl_proxy_get_version(proxy), WL_MARSHAL_FLAG_DESTROY);
}

}  // namespace

WaylandTimes::WaylandTimes(wl_display* display)
    : display_(display), queue_(wl_display_create_queue(display)) {
  // Objects made through the wrapper are in this queue from the start.
  auto* const wrapper = static_cast<wl_display*>(wl_proxy_create_wrapper(display));
  wl_proxy_set_queue(reinterpret_cast<wl_proxy*>(wrapper), queue_);
  registry_ = wl_display_get_registry(wrapper);
  wl_proxy_wrapper_destroy(wrapper);
  static constexpr wl_registry_listener kListener = {
      .global = [](void* self, wl_registry*, std::uint32_t name, const char* interface,
                   std::uint32_t) { static_cast<WaylandTimes*>(self)->add_global(name, interface); },
      .global_remove = [](void* self, wl_registry*,
                          std::uint32_t name) { static_cast<WaylandTimes*>(self)->remove_global(name); }};
  wl_registry_add_listener(registry_, &kListener, this);
  wl_display_roundtrip_queue(display_, queue_);  // seats
  wl_display_roundtrip_queue(display_, queue_);  // their devices
}

WaylandTimes::~WaylandTimes() {
  for (const auto& seat : seats_) close(*seat);
  destroy_extension(movement_manager_);
  wl_registry_destroy(registry_);
  wl_event_queue_destroy(queue_);
}

// Version 1 of a seat sends no other events than those that are handled here.
void WaylandTimes::add_global(std::uint32_t name, std::string_view interface) {
  if (interface == kManagerName && movement_manager_ == nullptr)
    movement_manager_ = static_cast<wl_proxy*>(wl_registry_bind(registry_, name, &kManagerInterface, 1));
  if (interface != wl_seat_interface.name) return;
  auto* const seat = static_cast<wl_seat*>(wl_registry_bind(registry_, name, &wl_seat_interface, 1));
  seats_.push_back(std::make_unique<Seat>(Seat{.times = this, .name = name, .seat = seat}));
  static constexpr wl_seat_listener kListener = {.capabilities =
                                                     [](void* data, wl_seat*, std::uint32_t capabilities) {
                                                       update_devices(*static_cast<Seat*>(data),
                                                                      capabilities);
                                                     },
                                                 .name = [](void*, wl_seat*, const char*) {}};
  wl_seat_add_listener(seat, &kListener, seats_.back().get());
}

void WaylandTimes::remove_global(std::uint32_t name) {
  std::erase_if(seats_, [name](const std::unique_ptr<Seat>& seat) {
    if (seat->name == name) close(*seat);
    return seat->name == name;
  });
}

// A seat gets and loses devices as they are plugged in and out.
void WaylandTimes::update_devices(Seat& io_seat, std::uint32_t capabilities) {
  const bool has_keyboard = (capabilities & WL_SEAT_CAPABILITY_KEYBOARD) != 0;
  const bool has_pointer = (capabilities & WL_SEAT_CAPABILITY_POINTER) != 0;
  if (has_keyboard && io_seat.keyboard == nullptr) listen_to_keyboard(io_seat);
  if (has_pointer && io_seat.pointer == nullptr) listen_to_pointer(io_seat);
  if (!has_keyboard && io_seat.keyboard != nullptr)
    wl_keyboard_destroy(std::exchange(io_seat.keyboard, nullptr));
  if (has_pointer || io_seat.pointer == nullptr) return;
  destroy_extension(std::exchange(io_seat.movement, nullptr));
  wl_pointer_destroy(std::exchange(io_seat.pointer, nullptr));
}

void WaylandTimes::listen_to_keyboard(Seat& io_seat) {
  io_seat.keyboard = wl_seat_get_keyboard(io_seat.seat);
  static const wl_keyboard_listener kListener = [] {
    wl_keyboard_listener listener{};
    listener.keymap = [](void*, wl_keyboard*, std::uint32_t, std::int32_t file, std::uint32_t) {
      ::close(file);
    };
    listener.enter = [](void*, wl_keyboard*, std::uint32_t, wl_surface*, wl_array*) {};
    listener.leave = [](void*, wl_keyboard*, std::uint32_t, wl_surface*) {};
    listener.key = [](void* self, wl_keyboard*, std::uint32_t, std::uint32_t time_ms, std::uint32_t,
                      std::uint32_t state) {
      static_cast<WaylandTimes*>(self)->add(
          state == WL_KEYBOARD_KEY_STATE_PRESSED ? Kind::kKeyDown : Kind::kKeyUp, time_ms);
    };
    listener.modifiers = [](void*, wl_keyboard*, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t,
                            std::uint32_t) {};
    return listener;
  }();
  wl_keyboard_add_listener(io_seat.keyboard, &kListener, io_seat.times);
}

void WaylandTimes::listen_to_pointer(Seat& io_seat) {
  io_seat.pointer = wl_seat_get_pointer(io_seat.seat);
  static const wl_pointer_listener kListener = [] {
    wl_pointer_listener listener{};
    listener.enter = [](void*, wl_pointer*, std::uint32_t, wl_surface*, wl_fixed_t, wl_fixed_t) {};
    listener.leave = [](void*, wl_pointer*, std::uint32_t, wl_surface*) {};
    listener.motion = [](void* self, wl_pointer*, std::uint32_t time_ms, wl_fixed_t, wl_fixed_t) {
      static_cast<WaylandTimes*>(self)->add(Kind::kMove, time_ms);
    };
    listener.button = [](void* self, wl_pointer*, std::uint32_t, std::uint32_t time_ms, std::uint32_t,
                         std::uint32_t state) {
      static_cast<WaylandTimes*>(self)->add(
          state == WL_POINTER_BUTTON_STATE_PRESSED ? Kind::kButtonDown : Kind::kButtonUp, time_ms);
    };
    listener.axis = [](void* self, wl_pointer*, std::uint32_t time_ms, std::uint32_t, wl_fixed_t) {
      static_cast<WaylandTimes*>(self)->add(Kind::kWheel, time_ms);
    };
    return listener;
  }();
  wl_pointer_add_listener(io_seat.pointer, &kListener, io_seat.times);

  wl_proxy* const manager = io_seat.times->movement_manager_;
  if (manager == nullptr) return;
  io_seat.movement = wl_proxy_marshal_flags(manager, kGetRelativePointer, &kMovementInterface,
                                            wl_proxy_get_version(manager), 0, nullptr, io_seat.pointer);
  static constexpr MovementListener kMovementListener = {[](void* self, wl_proxy*, std::uint32_t time_high,
                                                            std::uint32_t time_low, wl_fixed_t right,
                                                            wl_fixed_t down, wl_fixed_t, wl_fixed_t) {
    const std::uint64_t time_us = std::uint64_t{time_high} << 32 | time_low;
    static_cast<WaylandTimes*>(self)->events_.push_back(
        {Kind::kRelativeMove, static_cast<std::uint32_t>(time_us / 1000), wl_fixed_to_double(right),
         wl_fixed_to_double(down)});
  }};
  wl_proxy_add_listener(io_seat.movement,
                        reinterpret_cast<void (**)()>(const_cast<MovementListener*>(&kMovementListener)),
                        io_seat.times);
}

void WaylandTimes::close(Seat& io_seat) {
  update_devices(io_seat, 0);
  wl_seat_destroy(io_seat.seat);
}

std::optional<std::uint32_t> WaylandTimes::take(Kind kind) {
  wl_display_dispatch_queue_pending(display_, queue_);
  std::optional<std::uint32_t> time_ms;
  for (auto event = events_.begin(); event != events_.end();) {
    if (event->kind != kind) {
      ++event;
      continue;
    }
    time_ms = event->time_ms;
    right_ += event->right;
    down_ += event->down;
    event = events_.erase(event);
    if (kind != Kind::kRelativeMove || std::abs(right_) >= 1 || std::abs(down_) >= 1) break;
  }
  right_ -= std::trunc(right_);
  down_ -= std::trunc(down_);
  return time_ms;
}

void WaylandTimes::clear() {
  wl_display_dispatch_queue_pending(display_, queue_);
  events_.clear();
}

}  // namespace temblor::platform::sdl2
