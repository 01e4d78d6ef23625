#include "render/spans/repeat_spans.h"

#include <cmath>

#include "render/spans/kernel_planes.h"
#include "render/spans/repeating_texture.h"

namespace temblor::render {

namespace {

// The original's liquids: 8 texels either way, one turn every 128 texels, 20 of which pass each second.
constexpr float kTurbulence_texels = 8;
constexpr double kTurbulencePhase_texels_s = 20, kTurn_texels = 128;

ScreenPlane stretched(const ScreenPlane& plane, double factor) {
  return {plane.at_origin * factor, plane.dx * factor, plane.dy * factor};
}

RepeatingTexture make_texture(const SurfaceDraw& item, const ColorTables& tables, PixelFormat format,
                              base::Arena& arena) {
  const TexturePart whole{*item.texture, item.mip, 0, std::max(1u, item.texture->width >> item.mip)};
  const std::uint8_t* lit = tables.colormap.rows.data() + std::size_t{item.light_row} * 256;
  const bool has_holes = item.texture->kind == world::TextureKind::kCutout;
  // Full light is the texture as it is: the colormap's row for it may name an equal color by another index.
  const auto index_of = [&](std::uint8_t index) {
    const bool as_is = item.light_row == kLightAsStored || (has_holes && index == kClearIndex);
    return as_is ? index : lit[index];
  };
  if (format == PixelFormat::kIndexed) return copy_repeating<std::uint8_t>(whole, index_of, arena);
  return copy_repeating<std::uint32_t>(
      whole,
      [&](std::uint8_t index) {
        return has_holes && index == kClearIndex ? 0u : tables.rgb[index_of(index)];
      },
      arena);
}

}  // namespace

std::span<const RepeatRuns*> prepare_repeat_runs(const Scene& scene, const ViewFrame& view,
                                                 const SurfaceDraws& items, const ColorTables& tables,
                                                 PixelFormat format, base::Arena& arena) {
  const std::span<const RepeatRuns*> by_item =
      arena.allocate_filled<const RepeatRuns*>(items.items.size(), nullptr);
  // Items share their textures: by texture, mip level, and whether it is black.
  const std::span<RepeatingTexture> made =
      arena.allocate_filled(scene.level->textures.size() * 8, RepeatingTexture{});
  const double phase = std::fmod(scene.time_s * kTurbulencePhase_texels_s, kTurn_texels);
  for (std::size_t i = 0; i < items.items.size(); ++i) {
    const SurfaceDraw& item = items.items[i];
    if (item.kind != ItemKind::kLiquid && item.kind != ItemKind::kTexture) continue;
    RepeatingTexture& texture =
        made[base::to_size(item.texture_index) * 8 + item.mip * 2u + (item.light_row == kLightAsStored)];
    if (texture.texels == nullptr) texture = make_texture(item, tables, format, arena);

    const std::span<RepeatRuns> room = arena.allocate<RepeatRuns>(1);
    RepeatRuns& runs = room[0] = RepeatRuns{};
    runs.depth = kernel_plane(item.depth);
    runs.s = kernel_plane(stretched(
        item.s, texture.width / static_cast<double>(std::max(1u, item.texture->width >> item.mip))));
    runs.t = kernel_plane(stretched(
        item.t, texture.height / static_cast<double>(std::max(1u, item.texture->height >> item.mip))));
    runs.divide = view.perspective;
    runs.amplitude = item.kind == ItemKind::kLiquid ? kTurbulence_texels : 0;
    runs.phase = static_cast<float>(phase);
    runs.texels = texture.texels;
    runs.width = texture.width;
    runs.height = texture.height;
    by_item[i] = room.data();
  }
  return by_item;
}

}  // namespace temblor::render
