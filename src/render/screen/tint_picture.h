// Color laid over the finished view.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "render/color/color_tables.h"
#include "render/frame.h"
#include "render/scene.h"

namespace temblor::render {

// rgb: blend_rgb. Indexed: every entry becomes the one nearest to its blend; full-bright ones may stay so.
class PictureTint {
 public:
  PictureTint() = default;  // changes nothing, as one whose opacity is not positive
  PictureTint(const Tint& tint, const ColorTables& tables, PixelFormat format, bool vector_kernels);

  bool changes_pixels() const { return opacity_256_ > 0; }
  void apply(std::span<std::uint8_t> io_indexed) const;
  void apply(std::span<std::uint32_t> io_rgb) const;
  void apply_to_rows(RowRange rows, FrameBuffer& io_frame) const;

 private:
  int opacity_256_ = 0;
  std::uint32_t rgb_ = 0;
  std::array<std::uint8_t, 256> remap_{};
  bool vector_kernels_ = false;
};

void tint_picture(const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame);

}  // namespace temblor::render
