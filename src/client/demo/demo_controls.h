// Default controls for watching demos with keys and mouse. Stock Quake only played a demo to its end.
//
//   Space            pause, resume            , and .    one packet back, on; pauses
//   Left, Right      5 seconds; Shift: 30     Home, End  the start, the end
//   Up, Down         faster, slower           Backspace  original speed
//   Page Up, Down    previous, next demo
//   F                free camera and back: W A S D, E up, Q down, Shift faster, the mouse turns
//
// A camera that a seek or a new level leaves outside the level comes back to the player.
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
    // Degrees per mouse count.
    float turn_deg_per_count = 0.066f;
    // Units per second; Shift makes it four times as fast.
    float fly_speed = 400;
    // Demo time per real time, besides the demo's own speed (host_timescale).
    double time_scale = 1;
  };

  // Returns whether the event was used. Releases never are, as other parts of the client may wait for them
  // too.
  bool handle(const platform::InputEvent& event);
  // Carries out the requests since the last call and advances the demo, like DemoSession::advance(). Sets the
  // camera in `presentation` while flying.
  base::Result<bool> advance(double elapsed_s, PresentationSettings presentation, const Settings& settings,
                             const Presentation& shown, DemoSession& io_session);

  // How many demos to go forward (negative: back) since the last call.
  int take_demo_steps() { return std::exchange(demo_steps_, 0); }
  // Seconds since the last key that this class used; tells the owner when to hide the bar (draw_demo_bar()).
  double idle_s() const { return idle_s_; }
  // Whether the mouse should be captured: Window::capture_mouse().
  bool is_flying() const { return flies_; }

 private:
  enum Held { kForward, kBack, kLeft, kRight, kUp, kDown, kFast, kHeldKeys };

  bool press(platform::Key key);
  static std::optional<Held> find_held_key(platform::Key key);
  void change_speed(DemoSession& io_session) const;
  void fly(double elapsed_s, const Settings& settings, const Presentation& shown);
  bool is_seeking() const;
  base::Result<bool> advance_with_camera(double elapsed_s, PresentationSettings& io_presentation,
                                         const Presentation& shown, DemoSession& io_session);
  base::Result<bool> advance_session(double elapsed_s, const PresentationSettings& presentation,
                                     DemoSession& io_session);

  std::array<bool, kHeldKeys> held_{};
  FreeCamera camera_;
  bool flies_ = false, has_camera_ = false;
  const world::Level* camera_level_ = nullptr;  // where the camera was placed
  float turned_right_ = 0, turned_down_ = 0;    // mouse counts
  // Requests that advance() has not carried out yet.
  bool toggles_pause_ = false, seeks_begin_ = false, seeks_end_ = false, resets_speed_ = false;
  int speed_steps_ = 0, packet_steps_ = 0, demo_steps_ = 0;
  double seek_offset_s_ = 0;
  double idle_s_ = 0;
};

}  // namespace temblor::client
