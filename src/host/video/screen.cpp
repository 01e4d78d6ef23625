#include "host/video/screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/present.h"

namespace temblor::host {
namespace {

int scale_size(int pixels, float scale) {
  return std::clamp(static_cast<int>(std::lround(static_cast<float>(pixels) * scale)), 1, Screen::kMaxSize);
}

}  // namespace

render::FrameBuffer& Screen::begin(platform::PixelSize window_size, const ScreenSettings& settings) {
  scale_ = settings.scale * (settings.automatic_scale ? automatic_.scale() : 1.0f);
  scale_ = std::clamp(scale_, AutomaticScale::kMinScale, 1.0f);
  const int width = scale_size(window_size.width, scale_), height = scale_size(window_size.height, scale_);
  if (frame_.width() != width || frame_.height() != height || frame_.format() != settings.format) {
    shown_ = {};  // it may refer to the old frame buffer
    frame_ = render::FrameBuffer(width, height, settings.format);
  }
  return frame_;
}

// Applies the tone to a true-color frame in place, so it must be drawn again before it is shown again.
void Screen::finish(const formats::Palette& palette, const Tone& tone) {
  const ToneTable table = make_tone_table(tone);
  shown_ = std::as_const(frame_).rgb();
  if (frame_.format() == render::PixelFormat::kIndexed) {
    expanded_.resize(frame_.pixel_count());
    render::present(frame_, apply_tone(table, render::shown_palette(frame_, palette)), true, jobs_,
                    expanded_);
    shown_ = expanded_;
  } else if (!tone.is_neutral()) {
    apply_tone(table, jobs_, frame_.rgb());
  }
}

base::Status Screen::show(const formats::Palette& palette, const Tone& tone, platform::Window& io_window) {
  finish(palette, tone);
  return io_window.present({shown_, {frame_.width(), frame_.height()}}, jobs_);
}

}  // namespace temblor::host
