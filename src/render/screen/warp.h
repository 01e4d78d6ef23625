// The view under water: every pixel is taken from beside its place, by sines of the other coordinate, as the
// original does at 320x200; here at the picture's own size, scaled so that it looks alike at every size.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/large_memory.h"
#include "base/parallel_for.h"
#include "render/frame.h"
#include "render/screen/tint_picture.h"

namespace temblor::render {

class Warp {
 public:
  // Pixels only: depth stays as it was. The picture is shown slightly enlarged, so that nothing is taken
  // from beyond its borders. What has been moved is tinted while it is in the caches.
  void apply(double time_s, const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame);

  // Has the memory ready that apply() needs for such frames: the first one would wait for it. Costs nothing
  // where it is.
  void prepare(const FrameBuffer& frame);

 private:
  template <typename Pixel>
  struct Spare {
    base::LargeMemory<Pixel> pixels;
    std::size_t count = 0;
  };

  template <typename Pixel>
  static void reserve(std::size_t count, Spare<Pixel>& io_spare);
  template <typename Pixel>
  void move_pixels(std::span<const Pixel> pixels, Spare<Pixel>& io_spare, const PictureTint& tint,
                   base::Jobs& jobs, FrameBuffer& io_frame);

  // Pixel (x, y) shows pixel number column_[x] + row_[y] of the picture as it was.
  std::vector<std::int32_t> column_, row_;
  Spare<std::uint8_t> indexed_spare_;
  Spare<std::uint32_t> rgb_spare_;
};

}  // namespace temblor::render
