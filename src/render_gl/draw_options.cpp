#include "render_gl/draw_options.h"

namespace temblor::render_gl {

DrawOptions choose_options(WorldMethod method, const render::FrameContext& context) {
  if (context.is_indexed()) return {};
  const render::Settings& settings = context.settings;
  // Only methods that keep light on the card can update it in turns.
  const bool keeps_light = method != WorldMethod::kGouraud && method != WorldMethod::kStyleLayers;
  if (settings.relight_alternate && !keeps_light) method = WorldMethod::kLitTextures;
  if (settings.filter == render::TextureFilter::kNearest) return {.method = method};
  return {WorldMethod::kLitTextures, settings.filter, settings.sharp_texels};
}

render::PixelFormat find_block_format(const DrawOptions& options, const render::FrameContext& context) {
  return options.method == WorldMethod::kExpandedBlocks ? render::PixelFormat::kIndexed : context.format;
}

}  // namespace temblor::render_gl
