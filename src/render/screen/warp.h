// The view under water: every pixel is taken from beside its place, by sines of the other coordinate, as the
// original does at 320x200; here at the picture's own size, scaled so that it looks alike at every size.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel_for.h"
#include "render/frame.h"

namespace temblor::render {

class Warp {
 public:
  // Pixels only: depth stays as it was. The picture is shown slightly enlarged, so that nothing is taken
  // from beyond its borders.
  void apply(double time_s, base::Jobs& jobs, FrameBuffer& io_frame);

 private:
  template <typename Pixel>
  void move_pixels(std::span<Pixel> io_pixels, std::vector<Pixel>& io_copy, base::Jobs& jobs) const;

  // Pixel (x, y) shows pixel number column_[x] + row_[y] of the picture as it was.
  std::vector<std::int32_t> column_, row_;
  std::vector<std::uint8_t> indexed_copy_;
  std::vector<std::uint32_t> rgb_copy_;
};

}  // namespace temblor::render
