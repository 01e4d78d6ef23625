// Hot loop. The scalar reference: it defines the results of the kernels.
#include <cmath>

#include "lab/perspective/z_line_kernels.h"

namespace temblor::lab {

namespace {

float larger(float a, float b) {
  return a > b ? a : b;
}
float smaller(float a, float b) {
  return a < b ? a : b;
}

// Written so that NaN becomes 0.
std::int32_t clamped(float texel, std::int32_t last) {
  return static_cast<std::int32_t>(smaller(larger(texel, 0.0f), static_cast<float>(last)));
}

// A linear function along a span.
struct SpanLine {
  float base, step;
  SpanLine(const render::KernelPlane& plane, const render::Span& span)
      : base(static_cast<float>(plane.at_origin + plane.dx * span.x + plane.dy * span.y)),
        step(static_cast<float>(plane.dx)) {}
  float at(float lane) const { return base + lane * step; }
};

// The distance of each pixel of a span.
class SpanDistances {
 public:
  SpanDistances(const LineSpans& spans, const LineSpan& span)
      : z_(spans.z + (span.line - spans.first_line)),
        fraction_(span.fraction),
        lines_per_pixel_(spans.lines_per_pixel) {
    const float count = static_cast<float>(span.span.count);
    if (std::abs(lines_per_pixel_) * count > kLevelShare) return;
    is_level_ = true;
    level_z_ = at_line(fraction_ + (count - 1.0f) * 0.5f * lines_per_pixel_);
  }
  float at(int pixel) const {
    if (is_level_) return level_z_;
    if (lines_per_pixel_ == 1.0f) return between(pixel, fraction_);
    return at_line(fraction_ + static_cast<float>(pixel) * lines_per_pixel_);
  }

 private:
  float at_line(float line) const {
    const float whole = std::floor(line);
    return between(static_cast<int>(whole), line - whole);
  }
  float between(int line, float share) const { return z_[line] + share * (z_[line + 1] - z_[line]); }

  const float* z_;
  float fraction_, lines_per_pixel_;
  bool is_level_ = false;
  float level_z_ = 0;
};

template <typename Texel>
void draw_line_span(const LineSpans& spans, const LineSpan& line_span, const render::KernelTarget& target) {
  const render::SurfaceSpans& surface = spans.surface;
  const render::Span& span = line_span.span;
  const std::size_t first = span.y * target.width + span.x;
  const SpanLine depth(surface.depth, span), s(surface.s, span), t(surface.t, span);
  const SpanDistances distances(spans, line_span);
  for (int i = 0; i < span.count; ++i) {
    const float lane = static_cast<float>(i), z = distances.at(i);
    const std::size_t at = first + static_cast<std::size_t>(i);
    if (target.depth != nullptr) target.depth[at] = depth.at(lane);
    const std::int32_t texel = clamped(t.at(lane) * z, surface.last_t) * surface.texels_per_row +
                               clamped(s.at(lane) * z, surface.last_s);
    static_cast<Texel*>(target.pixels)[at] = static_cast<const Texel*>(surface.texels)[texel];
  }
}

}  // namespace

void fill_z_lines_scalar(const ZLines& lines, float* out_z) {
  const float step = static_cast<float>(lines.change);
  for (std::int32_t group = 0; group < lines.count; group += kLineGroup) {
    const float base = static_cast<float>(lines.at_origin + lines.change * (lines.first + group));
    for (std::int32_t i = 0; i < kLineGroup; ++i)
      out_z[group + i] = 1.0f / larger(base + static_cast<float>(i) * step, render::kMinSpanDepth);
  }
}

void draw_line_spans_u8_scalar(const LineSpans& spans, const render::KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_line_span<std::uint8_t>(spans, spans.spans[i], target);
}
void draw_line_spans_u32_scalar(const LineSpans& spans, const render::KernelTarget& target) {
  for (std::size_t i = 0; i < spans.span_count; ++i)
    draw_line_span<std::uint32_t>(spans, spans.spans[i], target);
}

}  // namespace temblor::lab
