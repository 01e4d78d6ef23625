// Presses keys and moves the mouse like a person, and watches a window until it shows a response.
//
// The events are made by the X server (XTEST), so that every program takes them as real. A small part of the
// window is read from the server again and again. The server draws and answers one request after the other,
// so a reading shows what a person could see at that moment, except for the delay of the display itself.
#pragma once

#include <xcb/xcb.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace temblor::bench {

enum class Action { kTurnByKey, kTurnByMouse };

class WindowProbe {
 public:
  // Waits up to 20 s for a window whose title begins so, and gives it the focus. Null: there is none.
  static std::unique_ptr<WindowProbe> find(const std::string& title);

  // Waits until the picture stands still, then turns the view left or right. Returns the time from the event
  // until the picture changes, in seconds, and nothing if it never stands still or never changes. Turns left
  // and right in turn.
  std::optional<double> measure(Action action);
  // When the last event was sent, on the clock of std::chrono::steady_clock, in seconds.
  double sent_s() const { return sent_s_; }

 private:
  struct Disconnect {
    void operator()(xcb_connection_t* connection) const { xcb_disconnect(connection); }
  };
  using Pixels = std::vector<std::uint8_t>;

  explicit WindowProbe(xcb_connection_t* connection);
  bool find_window(const std::string& title);
  xcb_keycode_t find_key(xcb_keysym_t symbol) const;
  Pixels read() const;
  std::optional<Pixels> wait_until_still() const;
  void send(std::uint8_t type, std::uint8_t detail, int right);

  std::unique_ptr<xcb_connection_t, Disconnect> connection_;
  xcb_window_t root_ = 0, window_ = 0;
  std::int16_t patch_x_ = 0, patch_y_ = 0;
  xcb_keycode_t left_key_ = 0, right_key_ = 0;
  bool is_next_left_ = true;
  double sent_s_ = 0;
};

}  // namespace temblor::bench
