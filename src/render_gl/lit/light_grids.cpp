#include "render_gl/lit/light_grids.h"

#include <bit>

#include "base/hash.h"
#include "render/surfaces/light/block_light.h"
#include "render_gl/lit/light_texel.h"

namespace temblor::render_gl {

namespace {

// 2048 tiles with stock light maps. Views with more are drawn in portions.
constexpr CacheOptions kLightCache{.bytes = std::size_t{8} << 20, .format = TexelFormat::kLight};

AtlasKey light_key(const render::BlockRequest& request, const render::SampleGrid& grid) {
  const render::BlockContents& contents = request.contents;
  AtlasKey key = 0;
  const auto add = [&](std::uint64_t value) { key = base::hash_with(key, value); };
  add(base::to_size(request.face));
  add(std::uint64_t{request.tile_s} << 32 | request.tile_t);
  for (const std::uint16_t value : contents.style_values) add(value);
  add(static_cast<std::uint64_t>(contents.light_view) << 1 | std::uint64_t{contents.colored});
  add(contents.caustic_step);
  add(contents.lights);
  add(static_cast<std::uint64_t>(grid.texels));
  return key;
}

}  // namespace

base::Result<LightGrids> LightGrids::make(const Functions& gl) {
  TRY(BlockAtlas atlas, BlockAtlas::make(gl, kLightCache));
  return LightGrids(std::move(atlas));
}

AtlasKey LightGrids::find_key(const world::Level& level, const render::BlockRequest& request) {
  return light_key(request, render::choose_block_grids(level, request).shown);
}

std::optional<LightGrids::Grid> LightGrids::place(const Functions& gl, const world::Level& level,
                                                  const render::BlockRequest& request) {
  const render::BlockGrids grids = render::choose_block_grids(level, request);
  const render::SampleGrid& shown = grids.shown;
  const auto texels = static_cast<unsigned>(render::at_mip(shown.texels, request.mip));
  const int texels_power = std::bit_width(texels) - 1;
  const AtlasKey key = light_key(request, shown);
  if (const auto stored = atlas_.reuse(key)) return Grid{stored->place, texels_power};
  scratch_.reset();
  const render::LightSums sums = render::sum_block_light(level, request, grids, scratch_);
  const auto columns = static_cast<std::size_t>(shown.columns);
  const std::span<const std::int16_t> samples = render::make_rgb_samples(sums, columns, scratch_);
  const render::SurfaceShape shape{shown.columns, shown.rows};
  packed_.resize(shape.texels());
  for (std::size_t i = 0; i < packed_.size(); ++i) packed_[i] = pack_light(&samples[i * 4]);
  const auto stored = atlas_.place(gl, {key, packed_.data(), shape});
  if (!stored) return std::nullopt;
  return Grid{stored->place, texels_power};
}

}  // namespace temblor::render_gl
