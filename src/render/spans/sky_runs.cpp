#include "render/spans/sky_runs.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace temblor::render {

namespace {

// As the original has them, for layers of 128 texels.
constexpr double kBackScroll_texels_s = 8, kCloudScroll_texels_s = 16, kSkyTexels = 378, kStockLayer = 128;
constexpr std::uint32_t kMostLayerTexels = 1024;

// The kernels wrap by masking: a layer of another size is stretched to the next power of two.
std::int32_t layer_size(std::uint32_t texels) {
  return static_cast<std::int32_t>(std::bit_ceil(std::clamp<std::uint32_t>(texels, 1, kMostLayerTexels)));
}

// `width` x `height` texels from the part of the texture that starts at column `left` and is `part` wide.
// A clear texel (index 0 of the clouds) is 0; others are as they are drawn.
template <typename Texel, typename Convert>
const void* copy_layer(const world::Texture& texture, std::uint32_t left, std::uint32_t part,
                       std::int32_t width, std::int32_t height, Convert convert, base::Arena& arena) {
  const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::span<Texel> layer = arena.allocate<Texel>(texels + kBlockPadding);
  Texel* out = layer.data();
  for (std::int32_t y = 0; y < height; ++y) {
    const std::size_t row =
        std::uint64_t{static_cast<std::uint32_t>(y)} * texture.height / static_cast<std::uint32_t>(height);
    const std::uint8_t* from = texture.mips[0].data() + row * texture.width + left;
    for (std::int32_t x = 0; x < width; ++x)
      *out++ = convert(
          from[std::uint64_t{static_cast<std::uint32_t>(x)} * part / static_cast<std::uint32_t>(width)]);
  }
  std::fill(layer.begin() + static_cast<std::ptrdiff_t>(texels), layer.end(), Texel{0});
  return layer.data();
}

void copy_vector(const math::Vec3d& from, double (&out)[3]) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = from[axis];
}

SkyLayers make_layers(const world::Texture& texture, const ViewFrame& view, double time_s,
                      const BuildTables& tables, PixelFormat format, base::Arena& arena) {
  SkyLayers layers{};
  SkyRuns& sky = layers.runs;
  const std::uint32_t clouds = std::max(1u, texture.width / 2), back_left = texture.width - clouds;
  sky.width = sky.texels_a_row = layer_size(clouds);
  sky.height = layer_size(texture.height);
  if (format == PixelFormat::kIndexed) {
    const auto as_is = [](std::uint8_t index) { return index; };
    sky.clouds = copy_layer<std::uint8_t>(texture, 0, clouds, sky.width, sky.height, as_is, arena);
    sky.back = copy_layer<std::uint8_t>(texture, back_left, clouds, sky.width, sky.height, as_is, arena);
  } else {
    const auto colour = [&](std::uint8_t index) { return tables.rgb[index]; };
    const auto clear = [&](std::uint8_t index) { return index == 0 ? 0u : tables.rgb[index]; };
    sky.clouds = copy_layer<std::uint32_t>(texture, 0, clouds, sky.width, sky.height, clear, arena);
    sky.back = copy_layer<std::uint32_t>(texture, back_left, clouds, sky.width, sky.height, colour, arena);
  }

  const double texels = sky.width / kStockLayer;
  sky.scale = static_cast<float>(kSkyTexels * texels);
  // The rest of a division in double: as exact after a day as after a second.
  const auto scrolled = [&](double speed, std::int32_t size) {
    const double offset = std::fmod(time_s * speed * texels, size);
    return static_cast<float>(offset < 0 ? offset + size : offset);
  };
  sky.clouds_s = scrolled(kCloudScroll_texels_s, sky.width);
  sky.clouds_t = scrolled(kCloudScroll_texels_s, sky.height);
  sky.back_s = scrolled(kBackScroll_texels_s, sky.width);
  sky.back_t = scrolled(kBackScroll_texels_s, sky.height);

  math::Vec3d forward = view.axes.forward, right{0.0}, down{0.0};
  if (view.perspective) {
    right = view.axes.right;
    down = -view.axes.up;
    forward = forward * view.pixels_per_unit - right * view.centre_x - down * view.centre_y;
  }
  copy_vector(forward, sky.forward);
  copy_vector(right, sky.right);
  copy_vector(down, sky.down);
  return layers;
}

}  // namespace

std::span<const SkyLayers*> prepare_sky_layers(const Scene& scene, const ViewFrame& view,
                                               const DrawItems& items, const BuildTables& tables,
                                               PixelFormat format, base::Arena& arena) {
  const std::span<const SkyLayers*> by_item =
      arena.allocate_filled<const SkyLayers*>(items.items.size(), nullptr);
  std::size_t last_sky = 0;  // few levels have two skies: the last one made usually serves the next item
  for (std::size_t i = 0; i < items.items.size(); ++i) {
    const DrawItem& item = items.items[i];
    if (item.kind != ItemKind::kSky) continue;
    if (by_item[last_sky] != nullptr && items.items[last_sky].texture == item.texture) {
      by_item[i] = by_item[last_sky];
      continue;
    }
    const std::span<SkyLayers> room = arena.allocate<SkyLayers>(1);
    room[0] = make_layers(*item.texture, view, scene.time_s, tables, format, arena);
    by_item[i] = room.data();
    last_sky = i;
  }
  return by_item;
}

}  // namespace temblor::render
