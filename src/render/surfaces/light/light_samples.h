// The light at the samples of one tile of a face: the light map's styles, plus dynamic lights.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/surfaces/light/face_lights.h"
#include "world/level.h"

namespace temblor::render {

// The samples that a tile needs, including the one after its last texel. `texels` between them: a power of
// two, at most 16.
SampleGrid sample_grid(const world::Face& face, int tile_s, int tile_t, std::int32_t texels = kTexelsASample);
// The distance of the samples from which a block of a mip level is lit: 16 for stock light maps. A texel of
// the block needs no more than one sample.
std::int32_t choose_sample_texels(const world::Level& level, const world::Face& face, int mip);

// The light that falls on the tile.
struct TileLight {
  std::array<std::uint16_t, 4> style_values{};  // by the face's styles; 256: the light as stored
  bool colored = false;                         // uses the level's colored samples, which must exist
  std::span<const FaceLight> lights;
};

// The sum of full light: a sample of 255 with a style value of 256.
inline constexpr std::uint32_t kFullLight = 65280;

// Row by row, `channels` values per sample: one (gray), or red, green, and blue.
struct LightSums {
  std::span<const std::uint32_t> values;
  std::size_t channels = 1;
};

// The sum of
//
//   sample * style value                                            over the face's styles, and
//   256 * (light at the nearest point - distance on face) * color   over the lights that reach the sample.
//
// If the brightest channel of a colored light map's sum exceeds full light, all three are scaled to make it
// so, before the lights are added: a flickering torch keeps its hue, and a light never darkens a channel.
//
// Samples of light maps that are not stock are interpolated between the four samples around their position,
// which is rounded to 1/256 of their distance, and rounded down.
//
// Has one channel if neither samples nor lights are colored. Lives in `arena`.
LightSums sum_light(const world::Level& level, const world::Face& face, const SampleGrid& grid,
                    const TileLight& light, base::Arena& arena);

}  // namespace temblor::render
