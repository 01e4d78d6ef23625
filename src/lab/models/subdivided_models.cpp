#include "lab/models/subdivided_models.h"

#include <algorithm>

#include "lab/models/prepare_with_settings.h"
#include "lab/models/split_triangles.h"
#include "render/alias/fill_alias.h"

namespace temblor::lab {

namespace {

void draw_models(std::span<const render::PreparedAlias> models, bool splits_light, render::RowRange rows,
                 render::FrameBuffer& io_frame) {
  const render::PixelFormat format = io_frame.format();
  for (const render::PreparedAlias& alias : models) {
    const render::TriangleTarget target = make_model_target(alias, rows, io_frame);
    if (target.row_begin >= target.row_end) continue;
    if (alias.by_subdivision && !splits_light)
      render::fill_alias(alias, format, false, target);
    else
      split_triangles(alias.job, {format, splits_light, alias.by_subdivision}, target);
  }
}

}  // namespace

render::TriangleTarget make_model_target(const render::PreparedAlias& alias, render::RowRange rows,
                                         render::FrameBuffer& io_frame) {
  void* const pixels = io_frame.format() == render::PixelFormat::kIndexed
                           ? static_cast<void*>(io_frame.indexed().data())
                           : io_frame.rgb().data();
  return {pixels,
          io_frame.depth().data(),
          io_frame.width(),
          0,
          std::max(rows.first, alias.first_row),
          std::min(rows.end, alias.row_end)};
}

render::FrameStages make_subdivided_models(std::span<const double> values, Counter* /*counter*/) {
  const bool splits_light = values[0] != 0;
  render::FrameStages stages;
  stages.prepare_alias_models = [](const render::FrameContext& context, const render::ViewFrame& view) {
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kSubdivision;
    return render::prepare_alias_models(with_settings(context, settings), view);
  };
  stages.draw_alias_models = [=](std::span<const render::PreparedAlias> models, bool /*simd_kernels*/,
                                 render::RowRange rows, render::FrameBuffer& io_frame) {
    draw_models(models, splits_light, rows, io_frame);
  };
  return stages;
}

}  // namespace temblor::lab
