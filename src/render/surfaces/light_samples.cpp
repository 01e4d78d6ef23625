#include "render/surfaces/light_samples.h"

#include <algorithm>

#include "render/edges/face_outlines.h"

namespace temblor::render {

namespace {

// Far above the brightest sum that shows, and far enough below 2^32 that adding one more light cannot
// overflow.
constexpr std::uint32_t kMaxSum = 1u << 28;

// `channels` must be the number of channels of the stored samples: 1 or 3. Each style of a face has a full
// grid of samples; the grids follow one another.
std::span<std::uint32_t> sum_styles(const world::Level& level, const world::Face& face,
                                    const SampleGrid& grid, const TileLight& light, std::size_t channels,
                                    base::Arena& arena) {
  const std::vector<std::uint8_t>& stored = channels == 3 ? level.light_rgb : level.light;
  const auto samples_per_row = static_cast<std::size_t>(face.light_width());
  const std::size_t row_values = static_cast<std::size_t>(grid.columns) * channels;
  const std::span<std::uint32_t> sums =
      arena.allocate_filled<std::uint32_t>(static_cast<std::size_t>(grid.rows) * row_values, 0);
  for (std::size_t style = 0; style < face.style_count; ++style)
    for (std::size_t row = 0; row < static_cast<std::size_t>(grid.rows); ++row) {
      const std::size_t sample_row = style * static_cast<std::size_t>(face.light_height()) +
                                     static_cast<std::size_t>(grid.first_row) + row;
      const std::uint8_t* samples = stored.data() + (face.light + sample_row * samples_per_row +
                                                     static_cast<std::size_t>(grid.first_column)) *
                                                        channels;
      for (std::size_t i = 0; i < row_values; ++i)
        sums[row * row_values + i] += std::uint32_t{samples[i]} * light.style_values[style];
    }
  return sums;
}

bool has_color(const FaceLight& light) {
  return light.color[0] != light.color[1] || light.color[0] != light.color[2];
}

std::span<std::uint32_t> in_three_channels(std::span<const std::uint32_t> gray, base::Arena& arena) {
  const std::span<std::uint32_t> sums = arena.allocate<std::uint32_t>(gray.size() * 3);
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = gray[i / 3];
  return sums;
}

void add_light(const FaceLight& light, const SampleGrid& grid, std::size_t channels,
               std::span<std::uint32_t> io_sums) {
  std::uint32_t* sum = io_sums.data();
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    const auto t = static_cast<float>((grid.first_row + row) * kTexelsASample);
    for (std::int32_t column = 0; column < grid.columns; ++column, sum += channels) {
      const auto s = static_cast<float>((grid.first_column + column) * kTexelsASample);
      const float distance = distance_on_face(light, s, t);
      if (!(distance < light.reach)) continue;
      const float amount = (light.at_nearest - distance) * 256.0f;
      for (std::size_t channel = 0; channel < channels; ++channel)
        sum[channel] =
            std::min(sum[channel], kMaxSum) + static_cast<std::uint32_t>(amount * light.color[channel]);
    }
  }
}

}  // namespace

SampleGrid sample_grid(const world::Face& face, int tile_s, int tile_t) {
  const std::int32_t column = tile_s * (kTileTexels / kTexelsASample);
  const std::int32_t row = tile_t * (kTileTexels / kTexelsASample);
  const std::int32_t most = kTileTexels / kTexelsASample + 1;
  return {column, row, std::min(face.light_width() - column, most),
          std::min(face.light_height() - row, most)};
}

LightSums sum_light(const world::Level& level, const world::Face& face, const SampleGrid& grid,
                    const TileLight& light, base::Arena& arena) {
  std::size_t channels = light.colored ? 3 : 1;
  std::span<std::uint32_t> sums = sum_styles(level, face, grid, light, channels, arena);
  if (channels == 1 && std::any_of(light.lights.begin(), light.lights.end(), has_color)) {
    sums = in_three_channels(sums, arena);
    channels = 3;
  }
  for (const FaceLight& one : light.lights) add_light(one, grid, channels, sums);
  return {sums, channels};
}

}  // namespace temblor::render
