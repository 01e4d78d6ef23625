// The underwater warp: every pixel is taken from a place displaced by sines of the other coordinate. Stock
// Quake draws a view of 320x200 and warps that; here the view is warped at its own size, scaled so that it
// looks the same at every size.
//
//   x' = place(x) + amplitude * sin(2 pi * (y / period + phase)), and y' likewise with x
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/large_memory.h"
#include "base/parallel_for.h"
#include "render/frame_buffer.h"
#include "render/screen/tint_picture.h"

namespace temblor::render {

// Pixel (x, y) of the warped picture shows pixel number column[x] + row[y] of the unwarped one.
struct WarpSources {
  std::vector<std::int32_t> column, row;
};
// For a picture of this size. The picture is slightly enlarged, so that nothing is taken from beyond its
// borders.
void find_warp_sources(int width, int height, double time_s, WarpSources& out_sources);

class Warp {
 public:
  // Changes pixels only; depth stays. The tint of rgb frames is applied while pixels are in the caches.
  void apply(double time_s, const PictureTint& tint, base::Jobs& jobs, FrameBuffer& io_frame);

  // Allocates the memory that apply() needs for frames of this size and format, so that the first frame under
  // water is not late. Does nothing if the memory exists.
  void prepare(const FrameBuffer& frame);

 private:
  template <typename Pixel>
  // The second buffer, which is exchanged with the frame's pixels after each warp.
  struct Spare {
    base::LargeMemory<Pixel> pixels;
    std::size_t count = 0;
  };

  template <typename Pixel>
  static void reserve(std::size_t count, Spare<Pixel>& io_spare);
  template <typename Pixel>
  void move_pixels(std::span<const Pixel> pixels, Spare<Pixel>& io_spare, const PictureTint& tint,
                   base::Jobs& jobs, FrameBuffer& io_frame);

  WarpSources sources_;
  Spare<std::uint8_t> indexed_spare_;
  Spare<std::uint32_t> rgb_spare_;
};

}  // namespace temblor::render
