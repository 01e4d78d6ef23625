// A color blended over the finished view, in rgb. Indexed frames are tinted when they are shown (present.h).
#pragma once

#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "render/frame_buffer.h"
#include "render/tint.h"

namespace temblor::render {

class PictureTint {
 public:
  PictureTint() = default;  // changes nothing, like a tint whose opacity is not positive
  PictureTint(const Tint& tint, PixelFormat format, bool simd_kernels);

  bool changes_pixels() const { return opacity_256_ > 0; }
  // 0 to 256, and 0xffRRGGBB; each channel becomes that of TintJob.
  int opacity() const { return opacity_256_; }
  std::uint32_t color() const { return rgb_; }
  void apply(std::span<std::uint32_t> io_rgb) const;
  void apply_to_rows(RowRange rows, FrameBuffer& io_frame) const;

 private:
  int opacity_256_ = 0;
  std::uint32_t rgb_ = 0;
  bool simd_kernels_ = false;
};

// Tints all rows in parallel.
void tint_picture(const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame);

}  // namespace temblor::render
