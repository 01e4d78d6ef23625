// The scalar reference of front_triangles_simd.cpp.
#include "render/alias/triangle_kernels.h"

namespace temblor::render {

namespace {

std::int32_t first_covered_pixel(std::int32_t steps) {
  static_assert(kSubpixels == 1 << 8);
  return (steps + (kSubpixels - 1)) >> 8;
}

std::int32_t least(std::int32_t a, std::int32_t b, std::int32_t c) {
  const std::int32_t ab = a < b ? a : b;
  return ab < c ? ab : c;
}
std::int32_t most(std::int32_t a, std::int32_t b, std::int32_t c) {
  const std::int32_t ab = a > b ? a : b;
  return ab > c ? ab : c;
}

std::int16_t to_row(std::int32_t row) {
  constexpr std::int32_t kLast = 32767;  // larger than any picture
  return static_cast<std::int16_t>(row < 0 ? 0 : row < kLast ? row : kLast);
}

}  // namespace

// Branchless: every triangle is written, and the count advances only if it is kept. Which way a triangle
// faces is unpredictable.
void find_front_triangles_scalar(const TriangleJob& job, FrontTriangles& io_fronts) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < job.triangle_count; ++i) {
    const std::uint32_t* corners = job.triangles + i * 3;
    const ScreenVertex &a = job.vertices[corners[0]], &b = job.vertices[corners[1]],
                       &c = job.vertices[corners[2]];
    const std::int64_t cross = (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
                               (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y);
    const std::int16_t top = to_row(first_covered_pixel(least(a.y, b.y, c.y)));
    const std::int16_t bottom = to_row(first_covered_pixel(most(a.y, b.y, c.y)));
    const bool has_columns =
        first_covered_pixel(least(a.x, b.x, c.x)) < first_covered_pixel(most(a.x, b.x, c.x));
    io_fronts.numbers[count] = static_cast<std::uint32_t>(i);
    io_fronts.rows[count] = {top, bottom};
    count += static_cast<std::size_t>(cross > 0) & static_cast<std::size_t>(has_columns) &
             static_cast<std::size_t>(top < bottom);
  }
  io_fronts.count = count;
}

}  // namespace temblor::render
