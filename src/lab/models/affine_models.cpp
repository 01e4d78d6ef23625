#include "lab/models/affine_models.h"

#include "lab/models/prepare_with_settings.h"

namespace temblor::lab {

render::FrameStages make_affine_models(std::span<const double> values, Counter* /*counter*/) {
  const bool has_subpixels = values[0] != 0, has_perspective = values[1] != 0;
  render::FrameStages stages;
  stages.prepare_alias_models = [=](const render::FrameContext& context, const render::ViewFrame& view) {
    render::Settings settings = context.settings;
    settings.alias_raster = render::AliasRaster::kAffine;
    settings.alias_snap = !has_subpixels;
    const auto placements = render::place_alias_models(context.scene, view, context.arena());
    const auto prepared = render::prepare_placed_models(with_settings(context, settings), view, placements);
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      prepared[i].job.perspective = has_perspective && placements[i].perspective;
      prepared[i].job.always_perspective = has_perspective;
    }
    return std::span<const render::PreparedAlias>(prepared);
  };
  return stages;
}

}  // namespace temblor::lab
