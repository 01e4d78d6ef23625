#include "render/surfaces/light/block_light.h"

#include <algorithm>

#include "render/surfaces/light/caustics.h"

namespace temblor::render {

namespace {

// The sum of light that shows the palette's colors as they are, in both pixel formats.
constexpr std::uint32_t kSumAsStored = 32768;

std::span<std::int16_t> allocate_samples(const LightSums& sums, std::size_t columns, std::size_t channels,
                                         base::Arena& arena) {
  const std::size_t count = sums.values.size() / sums.channels;
  return arena.allocate_filled<std::int16_t>((count + columns) * channels, 0);
}

}  // namespace

BlockGrids choose_block_grids(const world::Level& level, const BlockRequest& request) {
  const world::Face& face = level.face(request.face);
  const SampleGrid light =
      sample_grid(face, request.tile_s, request.tile_t, choose_sample_texels(level, face, request.mip));
  return {light, request.contents.caustic_step != 0 ? refine_for_caustics(light, request.mip) : light};
}

LightSums sum_block_light(const world::Level& level, const BlockRequest& request, const BlockGrids& grids,
                          base::Arena& arena) {
  const BlockContents& contents = request.contents;
  if (contents.light_view == LightView::kFullBright) {
    const std::size_t count =
        static_cast<std::size_t>(grids.shown.columns) * static_cast<std::size_t>(grids.shown.rows);
    return {arena.allocate_filled<std::uint32_t>(count, kSumAsStored), 1};
  }
  const world::Face& face = level.face(request.face);
  const LightSums sums =
      sum_light(level, face, grids.light, {contents.style_values, contents.colored, request.lights}, arena);
  if (contents.caustic_step == 0) return sums;
  return add_caustics(level, face, contents.caustic_step, sums, grids.light, grids.shown, arena);
}

std::span<const std::int16_t> make_dark_samples(const LightSums& sums, std::size_t columns,
                                                base::Arena& arena) {
  const std::span<std::int16_t> samples = allocate_samples(sums, columns, 1, arena);
  std::int16_t* out = samples.data();
  for (const std::uint32_t* sum = sums.values.data(); sum != sums.values.data() + sums.values.size();
       sum += sums.channels) {
    const std::uint32_t shown = std::min(*std::max_element(sum, sum + sums.channels), kFullLight);
    *out++ = static_cast<std::int16_t>(std::max((kFullLight - shown) >> 2, 64u));
  }
  return samples;
}

std::span<const std::int16_t> make_rgb_samples(const LightSums& sums, std::size_t columns,
                                               base::Arena& arena) {
  const std::span<std::int16_t> samples = allocate_samples(sums, columns, 4, arena);
  std::int16_t* out = samples.data();
  for (const std::uint32_t* sum = sums.values.data(); sum != sums.values.data() + sums.values.size();
       sum += sums.channels, out += 4)
    for (std::size_t channel = 0; channel < 3; ++channel)
      out[channel] =
          static_cast<std::int16_t>(std::min(sum[sums.channels == 3 ? 2 - channel : 0], kFullLight) >> 1);
  return samples;
}

}  // namespace temblor::render
