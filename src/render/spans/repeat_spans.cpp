#include "render/spans/repeat_spans.h"

#include "render/color/own_colors.h"
#include "render/color/warped_rows.h"
#include "render/spans/kernel_planes.h"
#include "render/spans/repeating_texture.h"

namespace temblor::render {

namespace {

constexpr std::size_t kMipLevels = formats::kMaxTextureDetail + 4;

ScreenPlane stretched(const ScreenPlane& plane, double factor) {
  return {plane.at_origin * factor, plane.dx * factor, plane.dy * factor};
}

std::uint32_t width_at_mip(const SurfaceDraw& draw) {
  return std::max(1u, at_mip(draw.texture->width, draw.mip));
}
std::uint32_t height_at_mip(const SurfaceDraw& draw) {
  return std::max(1u, at_mip(draw.texture->height, draw.mip));
}

// Converts a texture to pixels of the frame, light included.
RepeatingTexture make_texture(const SurfaceDraw& draw, const ColorTables& tables, PixelFormat format,
                              base::Arena& arena) {
  const TexturePart whole{*draw.texture, draw.mip, 0, width_at_mip(draw)};
  const std::uint8_t* indices = draw.texture->indices(draw.mip).data();
  const std::uint8_t* lit = tables.colormap.rows.data() + std::size_t{draw.light_row} * 256;
  const bool has_holes = draw.texture->kind == world::TextureKind::kCutout;
  // Full light skips the colormap: its row for full light may map an index to another one of equal color.
  const auto pick_index = [&](std::uint8_t index) {
    const bool as_is = draw.light_row == kLightAsStored || (has_holes && index == kClearIndex);
    return as_is ? index : lit[index];
  };
  if (format == PixelFormat::kIndexed)
    return copy_repeating<std::uint8_t>(
        whole, [&](std::size_t texel) { return pick_index(indices[texel]); }, arena);
  if (const OwnColors own = own_colors(*draw.texture, draw.mip); own.colors != nullptr)
    return copy_repeating<std::uint32_t>(
        whole, [&](std::size_t texel) { return unlit_color(own, texel, draw.light_row != kLightAsStored); },
        arena);
  return copy_repeating<std::uint32_t>(
      whole,
      [&](std::size_t texel) {
        const std::uint8_t index = indices[texel];
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
      arena.allocate_filled(context.level().textures.size() * kMipLevels * 2, RepeatingTexture{});
  const double phase = compute_turbulence_phase(context.scene.time_s);
  for (std::size_t i = 0; i < draws.all.size(); ++i) {
    const SurfaceDraw& draw = draws.all[i];
    if (draw.kind != SurfaceKind::kLiquid && draw.kind != SurfaceKind::kTexture) continue;
    const std::size_t level = base::to_size(draw.texture_index) * kMipLevels +
                              static_cast<std::size_t>(draw.mip + formats::kMaxTextureDetail);
    RepeatingTexture& texture = made[level * 2 + (draw.light_row == kLightAsStored)];
    if (texture.texels == nullptr) texture = make_texture(draw, context.colors, context.format, arena);

    const std::span<RepeatSpans> prepared = arena.allocate<RepeatSpans>(1);
    RepeatSpans& spans = prepared[0] = RepeatSpans{};
    spans.depth = kernel_plane(draw.depth);
    // Coordinates are in texels of the texture; the copy's sizes are powers of two, so they are scaled to
    // those.
    spans.s = kernel_plane(stretched(draw.s, texture.width / static_cast<double>(width_at_mip(draw))));
    spans.t = kernel_plane(stretched(draw.t, texture.height / static_cast<double>(height_at_mip(draw))));
    spans.divide = view.perspective;
    const double texel = 1.0 * texture.width / repeating_size(draw.texture->width);  // of mip 0, in texels
    spans.amplitude = static_cast<float>(draw.kind == SurfaceKind::kLiquid ? kTurbulence_texels * texel : 0);
    spans.turns_per_texel = static_cast<float>(1 / (kTurn_texels * texel));
    spans.phase = static_cast<float>(phase * texel);
    spans.texels = texture.texels;
    spans.width = texture.width;
    spans.height = texture.height;
    by_draw[i] = prepared.data();
  }
  return by_draw;
}

}  // namespace temblor::render
