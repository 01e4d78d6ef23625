// A color blended over the finished view. Stock Quake changes the display's palette instead, which costs
// nothing but also tints the status bar and menus.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/scene.h"

namespace temblor::render {

// Rgb: blend_rgb. Indexed: a table that maps every palette entry to the one nearest to its blend; only
// full-bright entries may map to full-bright ones.
class PictureTint {
 public:
  PictureTint() = default;  // changes nothing, like a tint whose opacity is not positive
  PictureTint(const Tint& tint, const ColorTables& tables, PixelFormat format, bool simd_kernels);

  bool changes_pixels() const { return opacity_256_ > 0; }
  void apply(std::span<std::uint8_t> io_indexed) const;
  void apply(std::span<std::uint32_t> io_rgb) const;
  void apply_to_rows(RowRange rows, FrameBuffer& io_frame) const;

 private:
  int opacity_256_ = 0;
  std::uint32_t rgb_ = 0;
  std::array<std::uint8_t, 256> remap_{};
  bool simd_kernels_ = false;
};

// Tints all rows in parallel.
void tint_picture(const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame);

}  // namespace temblor::render
