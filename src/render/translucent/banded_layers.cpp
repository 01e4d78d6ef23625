#include "render/translucent/banded_layers.h"

#include <algorithm>

#include "render/translucent/blend_sprite.h"

namespace temblor::render {

namespace {

void draw_sprite(const SpriteQuad& quad, const WorldPicture& world, const Band& band, FrameBuffer& io_frame) {
  const bool indexed = io_frame.format() == PixelFormat::kIndexed;
  const SpriteBlend blend{indexed ? world.colors.blends.table_for(quad.alpha) : nullptr,
                          opacity_256(quad.alpha), world.fog.is_on() ? &world.fog : nullptr};
  blend_sprite(quad, blend, world.colors, world.sources.simd_kernels,
               {band.first_row, band.first_row + band.row_count}, io_frame);
}

}  // namespace

// faces.translucent has the same order as the layers, so faces with no other layer between them are drawn
// with one call.
void draw_banded_layers(std::span<const TranslucentLayer> layers, const TranslucentOrder& order,
                        const WorldPicture& world, const Band& band, base::Arena& arena,
                        FrameBuffer& io_frame) {
  const auto is_sprite = [](const TranslucentLayer& layer) {
    return layer.kind == TranslucentLayer::Kind::kSprite;
  };
  for (auto layer = layers.begin(); layer != layers.end();) {
    if (is_sprite(*layer)) {
      draw_sprite(order.sprites[layer->number], world, band, io_frame);
      ++layer;
      continue;
    }
    const auto next = std::find_if(layer, layers.end(), is_sprite);
    draw_deferred_faces(
        order.faces.translucent.subspan(layer->number, static_cast<std::size_t>(next - layer)), world, band,
        arena, io_frame);
    layer = next;
  }
}

}  // namespace temblor::render
