// The times of a Wayland display's input events, which SDL 2 reads without them.
//
// A display sends an event to every keyboard or pointer object that a program has. So this object has its own
// on SDL's connection, in a queue of their own. Whenever SDL reads the connection, both queues are filled:
//
//   connection --SDL--> SDL's queue:  wl_keyboard.key -> SDL_KEYDOWN   (no time)
//                  '--> this queue:   wl_keyboard.key -> kKeyDown      at 81250 ms
//
// The n-th event of a kind since the last clear() is the n-th one of that kind that SDL has made. SDL sends
// no relative movement of less than a pixel, but adds it to the next.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

struct wl_display;
struct wl_event_queue;
struct wl_keyboard;
struct wl_pointer;
struct wl_proxy;
struct wl_registry;
struct wl_seat;

namespace temblor::platform::sdl2 {

class WaylandTimes {
 public:
  enum class Kind { kKeyDown, kKeyUp, kButtonDown, kButtonUp, kWheel, kMove, kRelativeMove };

  // `display` is SDL's and must outlive this object. Waits until the display has listed its devices.
  explicit WaylandTimes(wl_display* display);
  ~WaylandTimes();
  WaylandTimes(const WaylandTimes&) = delete;
  WaylandTimes& operator=(const WaylandTimes&) = delete;

  // Returns the time of the earliest event of this kind that has not been taken, in milliseconds on the
  // display's clock; nothing if there is none. Call it in the order of SDL's events.
  std::optional<std::uint32_t> take(Kind kind);
  // Forgets all events. Call it when SDL has no more.
  void clear();

 private:
  // A keyboard and a pointer of the display, and its movement; null while the display has none.
  struct Seat {
    WaylandTimes* times = nullptr;
    std::uint32_t name = 0;
    wl_seat* seat = nullptr;
    wl_keyboard* keyboard = nullptr;
    wl_pointer* pointer = nullptr;
    wl_proxy* movement = nullptr;
  };
  struct Event {
    Kind kind = Kind::kKeyDown;
    std::uint32_t time_ms = 0;
    // Pixels, of relative movement.
    double right = 0, down = 0;
  };

  void add_global(std::uint32_t name, std::string_view interface);
  void remove_global(std::uint32_t name);
  static void update_devices(Seat& io_seat, std::uint32_t capabilities);
  static void listen_to_keyboard(Seat& io_seat);
  static void listen_to_pointer(Seat& io_seat);
  static void close(Seat& io_seat);
  void add(Kind kind, std::uint32_t time_ms) { events_.push_back({kind, time_ms}); }

  wl_display* display_;
  wl_event_queue* queue_;
  wl_registry* registry_ = nullptr;
  // The maker of relative movement; null if the display has none.
  wl_proxy* movement_manager_ = nullptr;
  std::vector<std::unique_ptr<Seat>> seats_;
  std::deque<Event> events_;
  // Relative movement that SDL has not sent yet, in pixels.
  double right_ = 0, down_ = 0;
};

}  // namespace temblor::platform::sdl2
