// The interface to a window: it shows finished pictures and reports input.
//
//   host --present(Picture)--> Window --poll()--> InputEvents --> host
//
// The CPU renderer draws into its own memory; the window only copies, scales and presents. A renderer on the
// graphics card may draw into the window instead (open_gl). Implementations:
// platform/sdl2/window.h for a display, platform/headless/window.h for tests and machines without one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "platform/gl_context.h"
#include "platform/input_event.h"

namespace temblor::platform {

enum class WindowMode { kWindowed, kBorderless, kFullScreen };

// A size in real pixels, unless a comment says otherwise.
struct PixelSize {
  int width = 0, height = 0;
  bool operator==(const PixelSize&) const = default;
};

struct WindowSettings {
  // Windowed: the size of the client area in desktop units, which are more than one pixel on a scaled
  // desktop. Full screen: the size of the display mode.
  PixelSize size{1280, 720};
  WindowMode mode = WindowMode::kWindowed;
  int display = 0;    // index of the display; the first one if there is no such display
  bool vsync = true;  // ignored if the display does not support it
  bool operator==(const WindowSettings&) const = default;
};

// A finished picture: rows of 0xffRRGGBB from top to bottom, without padding. Does not own the pixels.
struct Picture {
  std::span<const std::uint32_t> pixels;
  PixelSize size;
};

class Window {
 public:
  virtual ~Window() = default;

  // Changes the window to the closest settings that the display supports. Fails only if the window is lost.
  virtual base::Status apply(const WindowSettings& settings) = 0;

  // Appends the events since the last call, in order.
  virtual void poll(std::vector<InputEvent>& io_events) = 0;
  // The clock of the events' times, in seconds from an arbitrary start. It never goes back.
  virtual double now_s() const = 0;

  // The size of the client area in real pixels, regardless of the desktop's scaling.
  virtual PixelSize size() const = 0;
  // False while the window is minimized: there is no need to draw.
  virtual bool is_visible() const = 0;
  // Shows the picture, stretched over the whole window. With vsync, it returns when the display has accepted
  // or shown the picture. The jobs share the work of copying.
  virtual base::Status present(const Picture& picture, base::Jobs& jobs) = 0;
  // A context that draws into the window, current on the calling thread. The caller destroys it before the
  // window, and before the next present(). Fails with kUnsupported if the window has no OpenGL 3.3 and no
  // OpenGL ES 3.0.
  virtual base::Result<std::unique_ptr<WindowGlContext>> open_gl() = 0;

  // Hides the pointer and reports relative movement, unaffected by the desktop's acceleration and edges.
  virtual void capture_mouse(bool captured) = 0;
  // Turns TextTyped events on or off.
  virtual void take_text(bool wanted) = 0;
  // Text in UTF-8; empty if there is none.
  virtual std::string clipboard() const = 0;
  virtual void set_clipboard(std::string_view text) = 0;
  // Runs the low-frequency and high-frequency motors of all gamepads, each at 0 to 1. Does nothing if there
  // is no gamepad with motors.
  virtual void rumble(float low, float high, double seconds) = 0;

  // 0 if it is unknown.
  virtual double refresh_rate_hz() const = 0;
  // The full-screen modes of a display, largest first. Displays are numbered from 0, as in WindowSettings;
  // the main display stands for unknown numbers.
  virtual std::vector<PixelSize> full_screen_sizes(int display) const = 0;
  // The number of displays.
  virtual int displays() const = 0;
  // How pictures reach the screen, for a person: "x11, shared memory, vsync off".
  virtual std::string describe() const = 0;
};

}  // namespace temblor::platform
