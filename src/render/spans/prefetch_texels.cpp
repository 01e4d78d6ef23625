#include "render/spans/prefetch_texels.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/large_memory.h"

namespace temblor::render {

namespace {

// In pixels, all four inclusive.
struct PixelBox {
  int left, right, top, bottom;
};

PixelBox bounding_box(std::span<const Span> spans) {
  PixelBox box{spans.front().x, 0, spans.front().y, spans.front().y};
  for (const Span& span : spans) {
    box.left = std::min<int>(box.left, span.x);
    box.right = std::max(box.right, span.x + span.count - 1);
    box.top = std::min<int>(box.top, span.y);
    box.bottom = std::max<int>(box.bottom, span.y);
  }
  return box;
}

struct TexelPoint {
  double s, t;
};

// Nothing if the face's plane is not in front of the eye at this pixel.
std::optional<TexelPoint> texel_at(const SurfaceDraw& draw, int x, int y, bool perspective) {
  const double depth = perspective ? draw.depth.at(x, y) : 1.0;
  if (depth <= 0) return std::nullopt;
  return TexelPoint{draw.s.at(x, y) / depth, draw.t.at(x, y) / depth};
}

// A row of pixels is a line in the texture: s as a function of the texel row t.
struct TexelLine {
  double s_at_zero, s_per_row;
  TexelLine(TexelPoint from, TexelPoint to) {
    const double rows = to.t - from.t;
    s_per_row = (to.s - from.s) / (rows != 0.0 ? rows : 1e-6);
    s_at_zero = from.s - from.t * s_per_row;
  }
  double at(double row) const { return s_at_zero + row * s_per_row; }
};

// Clamps; NaN, which huge faces and box corners far off the face can produce, becomes `least`.
double bounded(double value, double least, double most) {
  return value > least ? std::min(value, most) : least;
}

}  // namespace

void prefetch_texels(const SurfaceDraw& draw, std::span<const Span> spans, bool perspective,
                     std::size_t bytes_per_texel) {
  const PixelBox box = bounding_box(spans);
  const auto top_left = texel_at(draw, box.left, box.top, perspective);
  const auto top_right = texel_at(draw, box.right, box.top, perspective);
  const auto bottom_left = texel_at(draw, box.left, box.bottom, perspective);
  const auto bottom_right = texel_at(draw, box.right, box.bottom, perspective);
  if (!top_left || !top_right || !bottom_left || !bottom_right) return;

  // In each row of texels: the columns between the lines of the first and the last row of pixels, limited to
  // the box of the four corners.
  const auto [s_min, s_max] = std::minmax({top_left->s, top_right->s, bottom_left->s, bottom_right->s});
  const auto [t_min, t_max] = std::minmax({top_left->t, top_right->t, bottom_left->t, bottom_right->t});
  const SurfaceShape& shape = draw.block.shape;
  const double last_s = shape.width - 1, last_t = shape.height - 1;
  const double first_column = bounded(s_min, 0, last_s), last_column = bounded(s_max, 0, last_s);
  const int first_row = static_cast<int>(bounded(t_min, 0, last_t));
  const int last_row = static_cast<int>(bounded(t_max, 0, last_t));
  const TexelLine top(*top_left, *top_right), bottom(*bottom_left, *bottom_right);
  const auto texel_bytes = static_cast<std::ptrdiff_t>(bytes_per_texel);
  const std::ptrdiff_t row_bytes = shape.width * texel_bytes;
  const std::byte* row_texels = draw.block.texels + first_row * row_bytes;
  for (int row = first_row; row <= last_row; ++row, row_texels += row_bytes) {
    const double here = row + 0.5;
    const auto [left, right] = std::minmax({top.at(here), bottom.at(here)});
    const auto begin = static_cast<std::ptrdiff_t>(bounded(left, first_column, last_column)) * texel_bytes;
    const auto end = static_cast<std::ptrdiff_t>(bounded(right, first_column, last_column)) * texel_bytes;
    constexpr auto kLineBytes = static_cast<std::ptrdiff_t>(base::kCacheLineBytes);
    for (std::ptrdiff_t byte = begin; byte < end + kLineBytes; byte += kLineBytes)
      __builtin_prefetch(row_texels + byte);
  }
}

}  // namespace temblor::render
