#include "render/spans/sky_spans.h"

#include <algorithm>
#include <cmath>

#include "render/color/own_colors.h"
#include "render/spans/repeating_texture.h"

namespace temblor::render {

namespace {

// Stock Quake's scroll speeds and the size of its dome, for layers of 128 texels; larger layers scale them.
constexpr double kBackScroll_texels_s = 8, kCloudScroll_texels_s = 16, kSkyTexels = 378, kStockLayer = 128;
constexpr std::uint32_t kBlack = 0xff000000u;

// Clouds are clear where the index is 0, or the color black. In rgb, 0 also stands for clear, and no opaque
// color is 0.
SkySpans make_layers(const world::Texture& texture, const ViewFrame& view, double time_s,
                     const ColorTables& tables, PixelFormat format, base::Arena& arena) {
  SkySpans sky{};
  const int mip = texture.finest_mip();
  const std::uint32_t width = at_mip(texture.width, mip);
  const std::uint32_t clouds = std::max(1u, width / 2), back_left = width - clouds;
  const TexturePart front{texture, mip, 0, clouds}, behind{texture, mip, back_left, clouds};
  const std::uint8_t* indices = texture.indices(mip).data();
  const OwnColors own = own_colors(texture, mip);
  RepeatingTexture front_layer, back_layer;
  if (format == PixelFormat::kIndexed) {
    // By value: stores to bytes may change what a reference leads to, and would keep the loop from vectors.
    const auto as_is = [indices](std::size_t texel) { return indices[texel]; };
    front_layer = copy_repeating<std::uint8_t>(front, as_is, arena);
    back_layer = copy_repeating<std::uint8_t>(behind, as_is, arena);
  } else if (own.colors != nullptr) {
    const auto color = [&](std::size_t texel) { return unlit_color(own, texel, false); };
    const auto clear = [&](std::size_t texel) { return color(texel) == kBlack ? 0u : color(texel); };
    front_layer = copy_repeating<std::uint32_t>(front, clear, arena);
    back_layer = copy_repeating<std::uint32_t>(behind, color, arena);
  } else {
    const auto color = [&](std::size_t texel) { return tables.rgb[indices[texel]]; };
    const auto clear = [&](std::size_t texel) { return indices[texel] == 0 ? 0u : color(texel); };
    front_layer = copy_repeating<std::uint32_t>(front, clear, arena);
    back_layer = copy_repeating<std::uint32_t>(behind, color, arena);
  }
  sky.clouds = front_layer.texels;
  sky.back = back_layer.texels;
  sky.width = front_layer.width;
  sky.height = front_layer.height;

  const double texels = sky.width / kStockLayer;
  sky.scale = static_cast<float>(kSkyTexels * texels);
  // fmod in double: as precise after a day as after a second.
  const auto scrolled = [&](double speed, std::int32_t size) {
    const double offset = std::fmod(time_s * speed * texels, size);
    return static_cast<float>(offset < 0 ? offset + size : offset);
  };
  sky.clouds_s = scrolled(kCloudScroll_texels_s, sky.width);
  sky.clouds_t = scrolled(kCloudScroll_texels_s, sky.height);
  sky.back_s = scrolled(kBackScroll_texels_s, sky.width);
  sky.back_t = scrolled(kBackScroll_texels_s, sky.height);

  set_rays(sky_rays(view), sky);
  return sky;
}

}  // namespace

SkyRays sky_rays(const ViewFrame& view) {
  if (!view.perspective) return {view.axes.forward, math::Vec3d(0.0), math::Vec3d(0.0)};
  const math::Vec3d right = view.axes.right, down = -view.axes.up;
  return {view.axes.forward * view.pixels_per_unit - right * view.center_x - down * view.center_y, right,
          down};
}

std::span<const SkySpans*> prepare_sky_spans(const FrameContext& context, const ViewFrame& view,
                                             const SurfaceDraws& draws) {
  base::Arena& arena = context.arena();
  const std::span<const SkySpans*> by_draw =
      arena.allocate_filled<const SkySpans*>(draws.all.size(), nullptr);
  const std::span<const SkySpans*> by_texture =
      arena.allocate_filled<const SkySpans*>(context.level().textures.size(), nullptr);
  for (std::size_t i = 0; i < draws.all.size(); ++i) {
    const SurfaceDraw& draw = draws.all[i];
    if (draw.kind != SurfaceKind::kSky) continue;
    const SkySpans*& made = by_texture[base::to_size(draw.texture_index)];
    if (made == nullptr) {
      const std::span<SkySpans> prepared = arena.allocate<SkySpans>(1);
      prepared[0] =
          make_layers(*draw.texture, view, context.scene.time_s, context.colors, context.format, arena);
      made = prepared.data();
    }
    by_draw[i] = made;
  }
  return by_draw;
}

}  // namespace temblor::render
