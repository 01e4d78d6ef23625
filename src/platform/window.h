// A window that shows finished pictures and tells what the player does.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "platform/input_event.h"

namespace temblor::platform {

enum class WindowMode { kWindowed, kBorderless, kFullScreen };

struct PixelSize {
  int width = 0, height = 0;
  bool operator==(const PixelSize&) const = default;
};

struct WindowSettings {
  // Windowed: of the inside, in the desktop's units, which are several pixels where it scales; full screen:
  // of the display's mode.
  PixelSize size{1280, 720};
  WindowMode mode = WindowMode::kWindowed;
  int display = 0;    // one that is not there: the first
  bool vsync = true;  // where the display offers it
  bool operator==(const WindowSettings&) const = default;
};

// A finished picture: rows of 0xffRRGGBB.
struct Picture {
  std::span<const std::uint32_t> pixels;
  PixelSize size;
};

class Window {
 public:
  virtual ~Window() = default;

  // As near to these as the display allows. Fails where the window could not even be kept as it was.
  virtual base::Status apply(const WindowSettings& settings) = 0;

  // Appends what has happened since the last call, in order.
  virtual void poll(std::vector<InputEvent>& io_events) = 0;
  // Seconds since some moment; the clock that events are stamped with.
  virtual double now_s() const = 0;

  // Real pixels, however the desktop scales.
  virtual PixelSize size() const = 0;
  virtual bool is_visible() const = 0;
  // Shows the picture on all of the window, scaled where its size is another. Returns when it was handed
  // over, which with vsync is when the display has taken it. Copying is shared among the jobs.
  virtual base::Status present(const Picture& picture, base::Jobs& jobs) = 0;

  // Hides the pointer and reports how the mouse moves, without the desktop's acceleration and edges.
  virtual void capture_mouse(bool captured) = 0;
  // Whether keys are also reported as text.
  virtual void take_text(bool wanted) = 0;
  virtual std::string clipboard() const = 0;
  virtual void set_clipboard(std::string_view text) = 0;
  // Both 0 to 1. Nothing without a gamepad that can.
  virtual void rumble(float low, float high, double seconds) = 0;

  virtual double refresh_rate_hz() const = 0;  // 0: not known
  // Sizes of full-screen modes of the display it is on, largest first; and how many displays there are.
  virtual std::vector<PixelSize> full_screen_sizes() const = 0;
  virtual int displays() const = 0;
  // How pictures reach the screen, for a person: "x11, shared memory".
  virtual std::string describe() const = 0;
};

}  // namespace temblor::platform
