// From a scene to the window: the frame at the size that there is time for, what lies over it, its tone.
#pragma once

#include <vector>

#include "base/parallel_for.h"
#include "host/video/frame_limiter.h"
#include "host/video/tone.h"
#include "platform/window.h"
#include "render/frame.h"
#include "render/renderer.h"

namespace temblor::host {

struct ScreenSettings {
  render::PixelFormat format = render::PixelFormat::kRgb;
  float scale = 1;               // of the window's width and height, 0.5 to 1
  bool automatic_scale = false;  // down from `scale`, so that drawing takes no longer than target_s
  double target_s = 1.0 / 60;
  Tone tone{};
};

class Screen {
 public:
  // Pixels; a window that is wider or higher shows a frame of this many, scaled up.
  static constexpr int kLargest = 8192;

  // A frame of the size that the window asks for now. What it held is lost when the size changes.
  render::FrameBuffer& begin(platform::PixelSize window_size, const ScreenSettings& settings);
  const render::FrameBuffer& frame() const { return frame_; }
  // What was last shown; empty before.
  std::span<const std::uint32_t> pixels() const { return shown_; }
  // Shows it. `drawing_s`: what drawing it has taken, for the automatic scale.
  base::Status show(const formats::Palette& palette, const ScreenSettings& settings, double drawing_s,
                    platform::Window& io_window);
  float scale() const { return scale_; }

 private:
  base::Jobs jobs_{2, base::JobBackend::kStdThread};
  render::FrameBuffer frame_;
  std::vector<std::uint32_t> expanded_;  // of an indexed frame
  std::span<const std::uint32_t> shown_;
  AutomaticScale automatic_;
  float scale_ = 1;
};

}  // namespace temblor::host
