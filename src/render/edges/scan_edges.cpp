#include "render/edges/make_span_table.h"
#include "render/edges/scan_band.h"
#include "render/edges/span_table.h"

namespace temblor::render {

SpanTable scan_edges(const FrameContext& context, const ViewFrame& view, const EdgeTable& table) {
  const SurfaceRanks ranks = rank_surfaces(table.surfaces.first(table.first_deferred()), context.arena());
  return make_span_table(context, view, table, [&](RowRange rows, base::Arena& arena) {
    return scan_band(table, ranks, rows, view.width, arena);
  });
}

}  // namespace temblor::render
