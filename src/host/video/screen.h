// From the window's size to a frame buffer, and from the finished frame back to the window.
//
//   begin()   window size * scale -> frame buffer
//             (the renderer draws into it)
//   show()    finish(): palette (indexed frames only) -> tone
//             -> Window::present(), which scales it up
//
// OpenGL may draw into the window itself; then the frame buffer has pixels only if somebody wants to read
// them, and finish() applies the tone to those.
//
// The tone is applied to the palette of an indexed frame, 256 colors, but to each pixel of a true-color
// frame.
#pragma once

#include <vector>

#include "base/parallel_for.h"
#include "host/video/frame_limiter.h"
#include "host/video/tone.h"
#include "platform/window.h"
#include "render/frame_buffer.h"

namespace temblor::host {

struct ScreenSettings {
  render::PixelFormat format = render::PixelFormat::kRgb;
  float scale = 1;               // of the window's width and height, 0.5 to 1
  bool automatic_scale = false;  // lowers `scale` so that drawing takes at most target_s
  double target_s = 1.0 / 60;    // drawing time of a frame
  Tone tone{};
};

class Screen {
 public:
  // The largest width and height of a frame, in pixels. A larger window shows it scaled up.
  static constexpr int kMaxSize = 8192;

  // Returns the frame buffer to draw into, of the window's size times the scale, at least 1 x 1. Its pixels
  // are lost when the size or the format changes, and kept otherwise. It belongs to this object.
  render::FrameBuffer& begin(platform::PixelSize window_size, const ScreenSettings& settings);
  const render::FrameBuffer& frame() const { return frame_; }
  render::FrameBuffer& frame() { return frame_; }
  // The pixels that were last shown, 0xffRRGGBB, with the size of frame(). Empty before the first show() and
  // after a change of the size. Valid until the next begin().
  std::span<const std::uint32_t> pixels() const { return shown_; }
  // Adapts the automatic scale to the time that drawing took.
  void update_scale(const ScreenSettings& settings, double drawing_s) {
    if (settings.automatic_scale) automatic_.update(drawing_s, settings.target_s);
  }
  void forget_pixels() { shown_ = {}; }
  // Makes pixels() from the frame.
  void finish(const formats::Palette& palette, const Tone& tone);
  // Finishes and shows the frame. Fails if the window is lost.
  base::Status show(const formats::Palette& palette, const Tone& tone, platform::Window& io_window);
  float scale() const { return scale_; }

 private:
  // Threads for the tone and the scaling.
  base::Jobs jobs_{2, base::JobBackend::kStdThread};
  render::FrameBuffer frame_;
  std::vector<std::uint32_t> expanded_;  // an indexed frame as RGB
  std::span<const std::uint32_t> shown_;
  AutomaticScale automatic_;
  float scale_ = 1;
};

}  // namespace temblor::host
