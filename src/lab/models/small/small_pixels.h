// One small triangle whose corners lie at whole pixels, ready to be drawn, and one pixel of it.
//
// Depth, light, s, and t change evenly over the screen, and are the four lanes of a vector. g++ and clang
// compile its operations to SIMD instructions of every processor.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/alias/affine_triangle.h"

namespace temblor::lab {

using Values [[gnu::vector_size(16)]] = float;  // depth, light, s, t
using Wholes [[gnu::vector_size(16)]] = std::int32_t;
using Words [[gnu::vector_size(16)]] = std::int16_t;
using UnsignedWords [[gnu::vector_size(16)]] = std::uint16_t;

// The part for a model is set once. Code that is assembled at run time (assembled_shapes.cpp) knows the
// places of the fields.
struct SmallDrawing {
  // For a triangle: the values at corner a, and their change per column and row.
  Values at_a, per_column, per_row;
  // In all lanes: columns and rows from corner a to the first pixel.
  Values right, down;
  float* depth;  // of the first pixel
  void* pixels;
  // For a model: the largest values, with 0 for depth.
  Values most;
  const std::uint8_t* skin;
  const void* colors;
  std::size_t width;  // of a row of the target, in pixels
  std::int32_t skin_width;
  const render::TriangleJob* job;
  // The same as words, for assembled code.
  Words skin_steps;    // texels between neighbors along s and t, in lanes 2 and 3; lane 1 is 1
  UnsignedWords tint;  // rgb: blue, green, red of the light, in 32768ths
};

// The first pixel's column and row are 0.
inline Values find_column(const SmallDrawing& drawing, int column) {
  return drawing.at_a + drawing.per_column * (drawing.right + static_cast<float>(column));
}
inline Values find_row(const SmallDrawing& drawing, int row) {
  return drawing.per_row * (drawing.down + static_cast<float>(row));
}

inline std::uint8_t light_texel(const SmallDrawing& drawing, std::uint8_t texel, std::int32_t light,
                                std::uint8_t) {
  return static_cast<const std::uint8_t*>(drawing.colors)[(light & ~255) + texel];
}
inline std::uint32_t light_texel(const SmallDrawing& drawing, std::uint8_t texel, std::int32_t light,
                                 std::uint32_t) {
  return render::lit_color(*drawing.job, static_cast<const std::uint32_t*>(drawing.colors)[texel], light);
}

// Draws a pixel unless something nearer is there.
template <typename Pixel>
inline void draw_small_pixel(const SmallDrawing& drawing, Values values, float& io_depth, Pixel& io_pixel) {
  if (!(values[0] >= io_depth)) return;
  io_depth = values[0];
  values = values < drawing.most ? values : drawing.most;
  values = values > Values{} ? values : Values{};
  const Wholes whole = __builtin_convertvector(values, Wholes);
  const std::uint8_t texel = drawing.skin[whole[3] * drawing.skin_width + whole[2]];
  io_pixel = light_texel(drawing, texel, whole[1], Pixel{});
}

}  // namespace temblor::lab
