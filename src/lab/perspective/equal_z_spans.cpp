#include "lab/perspective/equal_z_spans.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/perspective/texel_error.h"
#include "lab/perspective/z_lines.h"
#include "render/spans/kernel_planes.h"
#include "render/spans/prefetch_texels.h"

namespace temblor::lab {

namespace {

// Rounds down.
constexpr std::int32_t to_group(std::int32_t line) {
  return line & ~(kLineGroup - 1);
}

// Draws the spans of a surface in batches, each with its own table.
class LineBatches {
 public:
  LineBatches(const render::SpanSources& sources, const render::SurfaceDraw& draw, const SurfaceLines& lines,
              const render::KernelTarget& target)
      : sources_(sources), lines_(lines), target_(target) {
    job_.surface = {.depth = render::kernel_plane(draw.depth),
                    .s = render::kernel_plane(draw.s),
                    .t = render::kernel_plane(draw.t),
                    .divide = render::KernelDivide::kEveryPixel,
                    .texels = draw.block.texels,
                    .texels_per_row = draw.block.shape.width,
                    .last_s = draw.block.shape.width - 1,
                    .last_t = draw.block.shape.height - 1,
                    .spans = nullptr,
                    .span_count = 0};
    job_.spans = spans_.data();
    job_.lines_per_pixel = static_cast<float>(lines.lines_per_pixel());
  }

  void add(const render::Span& span) {
    const double place = lines_.find_line(span.x, span.y), whole = std::floor(place);
    const auto line = static_cast<std::int32_t>(whole);
    const double last_place = place + lines_.lines_per_pixel() * (span.count - 1);
    const auto last = static_cast<std::int32_t>(std::floor(last_place));
    std::int32_t first = std::min(first_, std::min(line, last)), end = std::max(end_, std::max(line, last));
    if (job_.span_count == spans_.size() || end - first >= kMaxLines) {
      draw();
      first = std::min(line, last);
      end = std::max(line, last);
    }
    first_ = first;
    end_ = end;
    spans_[job_.span_count++] = {span, line, static_cast<float>(place - whole)};
  }

  void draw() {
    if (job_.span_count == 0) return;
    ZLines lines = lines_.plane();
    lines.first = to_group(first_) - kLineGroup;
    lines.count = to_group(end_) + 3 * kLineGroup - lines.first;
    sources_.simd_kernels ? fill_z_lines_simd(lines, z_.data()) : fill_z_lines_scalar(lines, z_.data());
    job_.z = z_.data();
    job_.first_line = lines.first;
    choose_kernel()(job_, target_);
    job_.span_count = 0;
    first_ = kNone;
    end_ = -kNone;
  }

 private:
  using Kernel = void (*)(const LineSpans&, const render::KernelTarget&);
  Kernel choose_kernel() const {
    if (sources_.format == render::PixelFormat::kIndexed)
      return sources_.simd_kernels ? draw_line_spans_u8_simd : draw_line_spans_u8_scalar;
    return sources_.simd_kernels ? draw_line_spans_u32_simd : draw_line_spans_u32_scalar;
  }

  static constexpr std::int32_t kNone = 1 << 30, kMaxLines = 4096;
  const render::SpanSources& sources_;
  const SurfaceLines& lines_;
  const render::KernelTarget& target_;
  LineSpans job_{};
  std::int32_t first_ = kNone, end_ = -kNone;  // lines of the batch
  std::array<LineSpan, 256> spans_;
  std::array<float, kMaxLines + 5 * kLineGroup> z_;
};

// One band of a frame.
class EqualZBand {
 public:
  EqualZBand(const render::SpanSources& sources, double max_texel_error, const render::KernelTarget& target)
      : sources_(sources), max_texel_error_(max_texel_error), target_(target) {}

  void draw(std::uint32_t number, std::span<const render::Span> spans) const {
    const render::SurfaceDraw& surface = sources_.draws.all[number];
    const SurfaceLines lines(surface, max_texel_error_);
    LineBatches batches(sources_, surface, lines, target_);
    // Runs of spans without lines are the engine's.
    for (std::size_t i = 0; i < spans.size();) {
      const std::size_t first = i;
      while (i < spans.size() && !lines.has_lines_for(spans[i])) ++i;
      if (i > first) render::draw_spans(sources_, number, spans.subspan(first, i - first), target_);
      for (; i < spans.size() && lines.has_lines_for(spans[i]); ++i) batches.add(spans[i]);
    }
    batches.draw();
  }

  Counts find_errors(std::uint32_t number, std::span<const render::Span> spans) const {
    const render::SurfaceDraw& surface = sources_.draws.all[number];
    const SurfaceLines lines(surface, max_texel_error_);
    Counts counts;
    for (const render::Span& span : spans) {
      if (!lines.has_lines_for(span)) continue;
      for (int i = 0; i < span.count; ++i)
        compare_texels(surface, {span.x + i, int{span.y}}, lines.find_distance(span, i), counts);
    }
    return counts;
  }

 private:
  const render::SpanSources& sources_;
  double max_texel_error_;
  const render::KernelTarget& target_;
};

}  // namespace

render::FrameStages make_equal_z_spans(std::span<const double> values, Counter* counter) {
  const double max_texel_error = values[0];
  render::FrameStages stages;
  stages.draw_band_spans = [=](const render::FrameContext& context, const render::ViewFrame& view,
                               const render::Band& band, const render::SpanSources& sources,
                               render::FrameBuffer& io_frame) {
    const bool indexed = context.is_indexed();
    const render::KernelTarget target{
        indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data(),
        sources.fill_depth ? io_frame.depth().data() : nullptr, static_cast<std::size_t>(io_frame.width())};
    const EqualZBand equal_z(sources, max_texel_error, target);
    for (std::size_t position = 0; position < band.draws.size(); ++position) {
      const std::uint32_t number = band.draws[position];
      if (number >= sources.draws.first_deferred) break;
      const render::SurfaceDraw& draw = sources.draws.all[number];
      // Parallel projection needs no division anyway.
      if (draw.kind == render::SurfaceKind::kBlock && view.perspective) {
        if (context.settings.prefetch)
          render::prefetch_texels(draw, band.spans_at(position), true, indexed ? 1 : 4);
        equal_z.draw(number, band.spans_at(position));
        if (counter != nullptr) counter->add(equal_z.find_errors(number, band.spans_at(position)));
        continue;
      }
      render::Band one = band;
      one.draws = band.draws.subspan(position, 1);
      one.span_begin = band.span_begin.subspan(position, 2);
      render::draw_band_spans(context, view, one, sources, io_frame);
    }
  };
  return stages;
}

}  // namespace temblor::lab
