#include "render/translucent/draw_translucent.h"

#include <optional>

#include "render/alias/draw_translucent_alias.h"
#include "render/translucent/banded_layers.h"
#include "render/translucent/merge_kernels.h"

namespace temblor::render {

namespace {

// Draws one model at a time into the whole frame.
class ModelDrawer {
 public:
  ModelDrawer(const FrameContext& context, const WorldPicture& world, FrameBuffer& io_frame)
      : context_(context), world_(world), frame_(io_frame) {}

  void draw_alias(const AliasInstance& instance, AliasRole role) {
    const std::optional<AliasPicture> picture = draw_alias_picture(context_, world_.view, instance, role);
    if (!picture) return;
    for (int row = 0; row < picture->height; ++row) merge_row(*picture, row, instance.alpha);
  }

 private:
  // Null for rgb frames, which need no table.
  const std::uint8_t* blend_table(float alpha) const {
    return frame_.format() == PixelFormat::kIndexed ? world_.colors.blends.table_for(alpha) : nullptr;
  }

  void merge_row(const AliasPicture& picture, int number, float alpha) {
    const bool indexed = frame_.format() == PixelFormat::kIndexed;
    const std::size_t first = static_cast<std::size_t>(number) * picture.stride;
    std::byte* const texels = static_cast<std::byte*>(picture.pixels) +
                              first * (indexed ? sizeof(std::uint8_t) : sizeof(std::uint32_t));
    float* const depth = picture.depth + first;
    if (world_.fog.is_on()) world_.fog.apply(texels, {depth, static_cast<std::size_t>(picture.width)});
    const std::size_t pixel =
        static_cast<std::size_t>(picture.y + number) * static_cast<std::size_t>(frame_.width()) +
        static_cast<std::size_t>(picture.x);
    MergeRow row{};
    row.texels = texels;
    row.depth = depth;
    row.pixels = indexed ? static_cast<void*>(frame_.indexed().data() + pixel) : frame_.rgb().data() + pixel;
    row.z = frame_.depth().data() + pixel;
    row.count = picture.width;
    row.nearer = 1;
    row.table = blend_table(alpha);
    row.opacity_256 = opacity_256(alpha);
    if (indexed)
      context_.settings.simd_kernels ? merge_blend_u8_simd(row) : merge_blend_u8_scalar(row);
    else
      context_.settings.simd_kernels ? merge_blend_u32_simd(row) : merge_blend_u32_scalar(row);
  }

  const FrameContext& context_;
  const WorldPicture& world_;
  FrameBuffer& frame_;
};

// Draws faces and sprites in all bands, in parallel.
void draw_bands(std::span<const TranslucentLayer> layers, const FrameContext& context,
                const TranslucentOrder& order, const WorldPicture& world, FrameBuffer& io_frame) {
  const std::span<const Band> bands = world.spans.bands;
  std::vector<base::Arena>& scratch = context.arenas.scratch;
  FrameArenas::grow(scratch, bands.size());
  context.jobs.parallel_for(bands.size(), [&](std::size_t number) {
    scratch[number].reset();
    draw_banded_layers(layers, order, world, bands[number], scratch[number], io_frame);
  });
}

}  // namespace

void draw_translucent(const FrameContext& context, const TranslucentOrder& order, const WorldPicture& world,
                      FrameBuffer& io_frame) {
  const Scene& scene = context.scene;
  const std::span<const TranslucentLayer> layers = order.layers.subspan(order.banded);
  ModelDrawer drawer(context, world, io_frame);
  for (std::size_t i = 0; i < layers.size();) {
    const TranslucentLayer& layer = layers[i];
    if (const std::size_t banded = count_banded_layers(layers.subspan(i)); banded > 0) {
      draw_bands(layers.subspan(i, banded), context, order, world, io_frame);
      i += banded;
      continue;
    }
    if (layer.kind == TranslucentLayer::Kind::kViewWeapon)
      drawer.draw_alias(*scene.view_weapon, AliasRole::kViewWeapon);
    else
      drawer.draw_alias(scene.alias_models[layer.number], AliasRole::kWorld);
    ++i;
  }
}

}  // namespace temblor::render
