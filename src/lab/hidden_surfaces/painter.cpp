#include "lab/hidden_surfaces/painter.h"

#include "lab/hidden_surfaces/draw_order.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

// The rows of the background behind all faces.
void add_background(render::RowRange rows, int width, base::ArenaVector<render::DrawSpan>& io_spans) {
  for (int row = rows.first; row < rows.end; ++row)
    io_spans.push_back({0, {0, static_cast<std::uint16_t>(row), static_cast<std::uint16_t>(width)}});
}

std::span<const render::DrawSpan> scan_all(const render::EdgeTable& table, const SurfaceEdges& edges,
                                           render::RowRange band, int width, base::Arena& arena) {
  base::ArenaVector<render::DrawSpan> spans(arena, 4096);
  add_background(band, width, spans);
  SurfaceScan scan(table, edges, band, width, arena);
  for (std::size_t surface = 1; surface < table.first_deferred(); ++surface) {
    const render::RowRange rows = scan.scan(surface);
    const std::uint32_t draw = table.surfaces[surface].first_draw;
    for (int row = rows.first; row < rows.end; ++row) {
      const RowSpan span = scan.span_at(row);
      if (span.first < span.end)
        spans.push_back({draw,
                         {static_cast<std::uint16_t>(span.first), static_cast<std::uint16_t>(row),
                          static_cast<std::uint16_t>(span.end - span.first)}});
    }
  }
  return spans.view();
}

}  // namespace

render::FrameStages make_painter(std::span<const double> values, Counter* counter) {
  render::FrameStages stages;
  const bool uses_pvs = values[0] != 0;
  if (!uses_pvs) {
    stages.find_visible_faces = [](const render::FrameContext& context, const render::ViewFrame& view,
                                   const render::LevelTables& tables) {
      render::Settings settings = context.settings;
      settings.use_pvs = false;
      const render::FrameContext everything{context.scene,  settings,     context.format,
                                            context.colors, context.jobs, context.arenas};
      return render::find_visible_faces(everything, view, tables);
    };
  }
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    const SurfaceEdges edges = group_edges(context, table);
    const render::SpanTable spans =
        render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena& arena) {
          return scan_all(table, edges, rows, view.width, arena);
        });
    if (counter != nullptr)
      counter->add({.bytes = edges.sides.size_bytes() + edges.begin.size_bytes() + edges.rows.size_bytes()});
    return order_draws(context, table, spans, order_back_to_front(context, table, edges, view.width));
  };
  return stages;
}

}  // namespace temblor::lab
