// Writes colors into frames of either format, for debug views and lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "formats/images/palette.h"
#include "render/frame_buffer.h"

namespace temblor::render {

// Writes colors into frames of either format.
class Painter {
 public:
  Painter(const formats::Palette& palette, FrameBuffer& io_frame) : palette_(palette), frame_(io_frame) {}

  void put(std::size_t pixel, formats::Rgb color) {
    if (frame_.format() == PixelFormat::kRgb)
      frame_.rgb()[pixel] = to_rgb(color);
    else
      frame_.indexed()[pixel] = nearest(color);
  }

 private:
  // The nearest palette entry. Remembers the last result, since spans have one color.
  std::uint8_t nearest(formats::Rgb color) {
    if (color == last_) return last_index_;
    int best = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < palette_.size(); ++i) {
      const int r = palette_[i].r - color.r, g = palette_[i].g - color.g, b = palette_[i].b - color.b;
      if (const int distance = r * r + g * g + b * b; distance < best) {
        best = distance;
        last_index_ = static_cast<std::uint8_t>(i);
      }
    }
    last_ = color;
    return last_index_;
  }

  const formats::Palette& palette_;
  FrameBuffer& frame_;
  formats::Rgb last_{1, 2, 3};
  std::uint8_t last_index_ = 0;
};

}  // namespace temblor::render
