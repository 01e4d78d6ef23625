// The light of one surface block, at the samples that it is interpolated from (build_surface.h has the
// formulas).
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/surfaces/build_surface.h"
#include "render/surfaces/light/light_samples.h"

namespace temblor::render {

// `light`: where light is computed. `shown`: the samples of the block, which caustics need closer together.
struct BlockGrids {
  SampleGrid light, shown;
};
BlockGrids choose_block_grids(const world::Level& level, const BlockRequest& request);

// All light of the request, at the samples `grids.shown`. Lives in `arena`.
LightSums sum_block_light(const world::Level& level, const BlockRequest& request, const BlockGrids& grids,
                          base::Arena& arena);

// Numbers of the samples, row by row, `columns` in each. There is one extra row, so that every row of texels
// has samples above and below it. Both live in `arena`.
//
// For `indexed`: the darkness of each sample's brightest channel.
std::span<const std::int16_t> make_dark_samples(const LightSums& sums, std::size_t columns,
                                                base::Arena& arena);
// For `rgb`: blue, green, red, and 0.
std::span<const std::int16_t> make_rgb_samples(const LightSums& sums, std::size_t columns,
                                               base::Arena& arena);

}  // namespace temblor::render
