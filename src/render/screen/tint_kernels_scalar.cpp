// Hot loop. The scalar reference of the tint kernel.
#include "render/screen/tint_kernels.h"

namespace temblor::render {

void tint_rgb_scalar(const TintJob& job, std::size_t first) {
  const auto over = static_cast<std::uint32_t>(job.opacity_256), under = 256 - over;
  for (std::size_t i = first; i < job.count; ++i) {
    std::uint32_t out = 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8)
      out |= (((job.color >> shift & 255) * over + (job.pixels[i] >> shift & 255) * under + 128) >> 8)
             << shift;
    job.pixels[i] = out;
  }
}

}  // namespace temblor::render
