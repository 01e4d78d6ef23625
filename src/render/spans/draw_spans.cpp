#include "render/spans/draw_spans.h"

#include <algorithm>
#include <limits>

#include "render/spans/prefetch_texels.h"

namespace temblor::render {

namespace {

// Where no face is: palette entry 0, infinitely far away.
void draw_background(std::span<const Span> spans, const ColorTables& tables, bool fill_depth,
                     FrameBuffer& io_frame) {
  for (const Span& span : spans) {
    const std::size_t first = std::size_t{span.y} * static_cast<std::size_t>(io_frame.width()) + span.x;
    if (io_frame.format() == PixelFormat::kIndexed)
      std::fill_n(io_frame.indexed().data() + first, span.count, std::uint8_t{0});
    else
      std::fill_n(io_frame.rgb().data() + first, span.count, tables.rgb[0]);
    if (fill_depth)
      std::fill_n(io_frame.depth().data() + first, span.count, std::numeric_limits<float>::lowest());
  }
}

}  // namespace

void draw_band_spans(const FrameContext& context, const ViewFrame& view, const Band& band,
                     const SpanSources& sources, FrameBuffer& io_frame) {
  const bool indexed = io_frame.format() == PixelFormat::kIndexed;
  const KernelTarget target{indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data(),
                            sources.fill_depth ? io_frame.depth().data() : nullptr,
                            static_cast<std::size_t>(io_frame.width())};
  for (std::size_t position = 0; position < band.draws.size(); ++position) {
    const std::uint32_t draw_number = band.draws[position];
    if (draw_number >= sources.draws.first_deferred) break;
    const SurfaceDraw& draw = sources.draws.all[draw_number];
    const std::span<const Span> spans = band.spans_at(position);
    if (draw.kind == SurfaceKind::kNothing)
      draw_background(spans, context.colors, sources.fill_depth, io_frame);
    if (draw.kind == SurfaceKind::kBlock && context.settings.prefetch)
      prefetch_texels(draw, spans, view.perspective, indexed ? 1 : 4);
    draw_spans(sources, draw_number, spans, target);
  }
}

}  // namespace temblor::render
