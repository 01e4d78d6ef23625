#include "render/spans/draw_spans.h"

#include <algorithm>
#include <limits>

#include "render/spans/prefetch_texels.h"

namespace temblor::render {

namespace {

// Where nothing is: palette entry 0, infinitely far.
void draw_background(std::span<const SpanRun> runs, const ColorTables& tables, bool fill_depth,
                     FrameBuffer& io_frame) {
  for (const SpanRun& run : runs) {
    const std::size_t first = std::size_t{run.y} * static_cast<std::size_t>(io_frame.width()) + run.x;
    if (io_frame.format() == PixelFormat::kIndexed)
      std::fill_n(io_frame.indexed().data() + first, run.count, std::uint8_t{0});
    else
      std::fill_n(io_frame.rgb().data() + first, run.count, tables.rgb[0]);
    if (fill_depth)
      std::fill_n(io_frame.depth().data() + first, run.count, std::numeric_limits<float>::lowest());
  }
}

}  // namespace

void draw_spans(const Settings& settings, const ViewFrame& view, const Band& band, const SpanSources& sources,
                const ColorTables& tables, FrameBuffer& io_frame) {
  const bool indexed = io_frame.format() == PixelFormat::kIndexed;
  const KernelTarget target{indexed ? static_cast<void*>(io_frame.indexed().data()) : io_frame.rgb().data(),
                            settings.fill_depth ? io_frame.depth().data() : nullptr,
                            static_cast<std::size_t>(io_frame.width())};
  for (std::size_t position = 0; position < band.items.size(); ++position) {
    const std::uint32_t item_number = band.items[position];
    if (item_number >= sources.items.first_late) break;
    const SurfaceDraw& item = sources.items.items[item_number];
    const std::span<const SpanRun> runs = band.runs_at(position);
    if (item.kind == ItemKind::kNothing) draw_background(runs, tables, settings.fill_depth, io_frame);
    if (item.kind == ItemKind::kSurface && settings.prefetch)
      prefetch_texels(item, runs, view.perspective, indexed ? 1 : 4);
    draw_runs(sources, item_number, runs, target);
  }
}

}  // namespace temblor::render
