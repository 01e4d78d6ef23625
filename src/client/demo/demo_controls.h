// What somebody who watches a recording does with keys and mouse, by default.
//
//   Space            pauses, goes on           , and .     a packet back, on; pauses
//   Left, Right      5 seconds; Shift: 30      Home, End   the beginning, the end
//   Up, Down         faster, slower            Backspace   as fast as it was
//   Page Up, Down    the recording before, after
//   F                a camera of one's own, and back to the player's eyes: W A S D, E up, Q down, Shift
//   faster,
//                    the mouse turns it
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "client/demo/demo_session.h"
#include "client/view/free_camera.h"
#include "platform/input_event.h"

namespace temblor::client {

class DemoControls {
 public:
  struct Settings {
    float turn_deg_per_count = 0.066f;  // of the mouse
    float fly_speed = 400;              // units a second
  };

  // Whether it was for these keys. A key that is let go is never theirs alone.
  bool handle(const platform::InputEvent& event);
  // Does what was asked for since the last time, and lets time go by: as DemoSession::advance(), to whose
  // presentation a camera of one's own is given.
  base::Result<bool> advance(double passed_s, PresentationSettings presentation, const Settings& settings,
                             const Presentation& shown, DemoSession& io_session);

  // How many recordings on (back: negative) were asked for since the last time.
  int take_recordings() { return std::exchange(recordings_, 0); }
  // Seconds since anything was asked for: a bar of the recording (draw_demo_bar) may go again.
  double idle_s() const { return idle_s_; }
  // The mouse is wanted: Window::capture_mouse().
  bool is_flying() const { return flies_; }

 private:
  enum Held { kForward, kBack, kLeft, kRight, kUp, kDown, kFast, kHeldKeys };

  bool press(platform::Key key);
  static std::optional<Held> held_by(platform::Key key);
  void set_speed(DemoSession& io_session) const;
  void fly(double passed_s, const Settings& settings, const Presentation& shown);
  base::Result<bool> go(double passed_s, const PresentationSettings& presentation, DemoSession& io_session);

  std::array<bool, kHeldKeys> held_{};
  FreeCamera camera_;
  bool flies_ = false, has_place_ = false;
  float turned_right_ = 0, turned_down_ = 0;  // counts
  // What is asked for.
  bool turns_pause_ = false, seeks_begin_ = false, seeks_end_ = false, resets_speed_ = false;
  int faster_ = 0, packets_ = 0, recordings_ = 0;
  double seconds_ = 0;
  double idle_s_ = 0;
};

}  // namespace temblor::client
