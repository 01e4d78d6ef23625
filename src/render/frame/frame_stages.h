// The stages that the laboratory can replace, as functions with the types of the engine's own stages. A frame
// calls each once, and those that draw once for each band.
#pragma once

#include <functional>

#include "render/alias/draw_alias_models.h"
#include "render/edges/span_table.h"
#include "render/spans/draw_spans.h"
#include "render/surfaces/surface_draws.h"
#include "render/view/visible_faces.h"

namespace temblor::render {

// By default the engine's own stages. The headers of those describe what each has to return.
struct FrameStages {
  std::function<VisibleFaces(const FrameContext& context, const ViewFrame& view, const LevelTables& tables)>
      find_visible_faces = render::find_visible_faces;
  std::function<SpanTable(const FrameContext& context, const ViewFrame& view, const EdgeTable& table)>
      scan_edges = render::scan_edges;
  // A draw without a block must be drawn by `draw_band_spans`.
  std::function<SurfaceBlocks(const FrameContext& context, const SurfaceRequests& requests,
                              SurfaceCache& io_cache)>
      reserve_surfaces = render::reserve_surfaces;
  std::function<void(const FrameContext& context, const SurfaceBlocks& blocks, const MarkTables* mark_tables)>
      build_surfaces = render::build_surfaces;
  // Called by several threads at once, for different bands.
  std::function<void(const FrameContext& context, const ViewFrame& view, const Band& band,
                     const SpanSources& sources, FrameBuffer& io_frame)>
      draw_band_spans = render::draw_band_spans;
  // Opaque alias models; only in frames with depth.
  std::function<std::span<const PreparedAlias>(const FrameContext& context, const ViewFrame& view)>
      prepare_alias_models = render::prepare_alias_models;
  // Called by several threads at once, for different rows.
  std::function<void(std::span<const PreparedAlias> models, bool simd_kernels, RowRange rows,
                     FrameBuffer& io_frame)>
      draw_alias_models = render::draw_alias_models;
};

}  // namespace temblor::render
