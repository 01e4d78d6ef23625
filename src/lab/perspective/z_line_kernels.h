// Inner loops that draw spans of a surface with distances from a table, as SIMD and as the scalar reference
// with the same results, bit for bit. This header has plain types only, because the SIMD file is compiled for
// several processors.
//
// On a flat surface, 1/z is linear on the screen, so pixels of equal z form parallel lines. The table has the
// distance z for each line, and pixels between two lines interpolate:
//
//   line    0   1   2   3 ...
//   row 0   |---|---|---|---      a span crosses a line at each pixel (lines_per_pixel 1), fewer, or none
//   row 1    \   \   \   \        (a floor's lines are the rows)
#pragma once

#include "render/spans/span_kernels.h"

namespace temblor::lab {

// Tables are filled in groups of so many lines, the first of which is a multiple of it. So a line has the
// same distance in every table.
constexpr std::int32_t kLineGroup = 16;
// Steep lines cross at most so many pixels of a row from one pixel to the next.
constexpr double kMaxLinesPerPixel = 0.9;
// If a span crosses less of the way from line to line than this, all of it has one distance.
constexpr float kLevelShare = 1.0f / 4096;

// z of lines `first` to first + count - 1: 1 / (at_origin + change * line). Both numbers are multiples of
// kLineGroup.
struct ZLines {
  double at_origin, change;
  std::int32_t first, count;
};

// A span, and the place of its first pixel: line + fraction, which is from 0 to 1.
struct LineSpan {
  render::Span span;
  std::int32_t line;
  float fraction;
};

struct LineSpans {
  render::SurfaceSpans surface;  // without spans; `divide` is not used
  const LineSpan* spans;
  std::size_t span_count;
  // The table begins with line number `first_line`. It has a group of lines more than spans need before them,
  // and two groups more after them.
  const float* z;
  std::int32_t first_line;
  float lines_per_pixel;  // to the right: 1, or -kMaxLinesPerPixel to kMaxLinesPerPixel
};

void fill_z_lines_scalar(const ZLines& lines, float* out_z);
void draw_line_spans_u8_scalar(const LineSpans& spans, const render::KernelTarget& target);
void draw_line_spans_u32_scalar(const LineSpans& spans, const render::KernelTarget& target);

void fill_z_lines_simd(const ZLines& lines, float* out_z);
void draw_line_spans_u8_simd(const LineSpans& spans, const render::KernelTarget& target);
void draw_line_spans_u32_simd(const LineSpans& spans, const render::KernelTarget& target);

}  // namespace temblor::lab
