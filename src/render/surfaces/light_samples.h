// The light of one tile of a face at its samples: the light map's styles, and dynamic lights on top.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/surfaces/face_lights.h"
#include "world/level.h"

namespace temblor::render {

// The samples that a tile needs: up to the one after its last texel.
SampleGrid sample_grid(const world::Face& face, int tile_s, int tile_t);

struct TileLight {
  std::array<std::uint16_t, 4> style_values{};  // by the face's styles; 256: the light as stored
  bool colored = false;                         // from the level's colored samples, which it has
  std::span<const FaceLight> lights;
};

// 256 is a light of 1. Row by row, `channels` values a sample: one, or red, green and blue.
struct LightSums {
  std::span<const std::uint32_t> values;
  std::size_t channels = 1;
};

// sample x style value over the face's styles, and 256 x (light at the nearest point - distance on the face)
// x color over the lights that reach that far. Gray where nothing has a color. Lives as long as `arena`.
LightSums sum_light(const world::Level& level, const world::Face& face, const SampleGrid& grid,
                    const TileLight& light, base::Arena& arena);

}  // namespace temblor::render
