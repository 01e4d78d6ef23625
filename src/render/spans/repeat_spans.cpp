#include "render/spans/repeat_spans.h"

#include <cmath>

#include "render/spans/kernel_planes.h"
#include "render/spans/repeating_texture.h"

namespace temblor::render {

namespace {

// Stock Quake's liquids: an amplitude of 8 texels and a period of 128 texels, moving by 20 texels per second.
constexpr float kTurbulence_texels = 8;
constexpr double kTurbulencePhase_texels_s = 20, kTurn_texels = 128;

ScreenPlane stretched(const ScreenPlane& plane, double factor) {
  return {plane.at_origin * factor, plane.dx * factor, plane.dy * factor};
}

// Converts a texture to pixels of the frame, light included.
RepeatingTexture make_texture(const SurfaceDraw& draw, const ColorTables& tables, PixelFormat format,
                              base::Arena& arena) {
  const TexturePart whole{*draw.texture, draw.mip, 0, std::max(1u, draw.texture->width >> draw.mip)};
  const std::uint8_t* lit = tables.colormap.rows.data() + std::size_t{draw.light_row} * 256;
  const bool has_holes = draw.texture->kind == world::TextureKind::kCutout;
  // Full light skips the colormap: its row for full light may map an index to another one of equal color.
  const auto pick_index = [&](std::uint8_t index) {
    const bool as_is = draw.light_row == kLightAsStored || (has_holes && index == kClearIndex);
    return as_is ? index : lit[index];
  };
  if (format == PixelFormat::kIndexed) return copy_repeating<std::uint8_t>(whole, pick_index, arena);
  return copy_repeating<std::uint32_t>(
      whole,
      [&](std::uint8_t index) {
        return has_holes && index == kClearIndex ? 0u : tables.rgb[pick_index(index)];
      },
      arena);
}

}  // namespace

std::span<const RepeatSpans*> prepare_repeat_spans(const FrameContext& context, const ViewFrame& view,
                                                   const SurfaceDraws& draws) {
  base::Arena& arena = context.arena();
  const std::span<const RepeatSpans*> by_draw =
      arena.allocate_filled<const RepeatSpans*>(draws.all.size(), nullptr);
  // Draws share converted textures, by texture, mip level, and whether they are lit or black.
  const std::span<RepeatingTexture> made =
      arena.allocate_filled(context.level().textures.size() * 8, RepeatingTexture{});
  const double phase = std::fmod(context.scene.time_s * kTurbulencePhase_texels_s, kTurn_texels);
  for (std::size_t i = 0; i < draws.all.size(); ++i) {
    const SurfaceDraw& draw = draws.all[i];
    if (draw.kind != SurfaceKind::kLiquid && draw.kind != SurfaceKind::kTexture) continue;
    RepeatingTexture& texture =
        made[base::to_size(draw.texture_index) * 8 + draw.mip * 2u + (draw.light_row == kLightAsStored)];
    if (texture.texels == nullptr) texture = make_texture(draw, context.colors, context.format, arena);

    const std::span<RepeatSpans> prepared = arena.allocate<RepeatSpans>(1);
    RepeatSpans& spans = prepared[0] = RepeatSpans{};
    spans.depth = kernel_plane(draw.depth);
    // Coordinates are in texels of the texture; the copy's sizes are powers of two, so they are scaled to
    // those.
    spans.s = kernel_plane(stretched(
        draw.s, texture.width / static_cast<double>(std::max(1u, draw.texture->width >> draw.mip))));
    spans.t = kernel_plane(stretched(
        draw.t, texture.height / static_cast<double>(std::max(1u, draw.texture->height >> draw.mip))));
    spans.divide = view.perspective;
    spans.amplitude = draw.kind == SurfaceKind::kLiquid ? kTurbulence_texels : 0;
    spans.phase = static_cast<float>(phase);
    spans.texels = texture.texels;
    spans.width = texture.width;
    spans.height = texture.height;
    by_draw[i] = prepared.data();
  }
  return by_draw;
}

}  // namespace temblor::render
