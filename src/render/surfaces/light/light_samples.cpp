#include "render/surfaces/light/light_samples.h"

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

// A position between samples of a light map.
struct BetweenSamples {
  std::size_t before, after;  // columns or rows
  std::uint32_t share_q8;     // of `after`, from 0 to 255
};
BetweenSamples find_between(double position, std::int32_t count) {
  const double last = count - 1;
  const auto position_q8 = static_cast<std::uint32_t>(std::clamp(position, 0.0, last) * 256 + 0.5);
  const std::size_t before = position_q8 >> 8;
  return {before, std::min(before + 1, static_cast<std::size_t>(count) - 1), position_q8 & 255};
}

// Interpolates between four samples of one channel; the result is in 16.16 fixed point.
std::uint64_t interpolate_q16(const std::uint8_t* samples, std::size_t row_values, std::size_t channels,
                              const BetweenSamples& x, const BetweenSamples& y) {
  const std::uint8_t *above = samples + y.before * row_values, *below = samples + y.after * row_values;
  const std::size_t left = x.before * channels, right = x.after * channels;
  const std::uint32_t upper = above[left] * (256 - x.share_q8) + above[right] * x.share_q8;
  const std::uint32_t lower = below[left] * (256 - x.share_q8) + below[right] * x.share_q8;
  return upper * (256 - y.share_q8) + lower * y.share_q8;
}

// Does the same as sum_styles() for a light map whose samples do not lie on the grid. Positions are computed,
// never accumulated, so that adjacent tiles are lit the same along their seam.
std::span<std::uint32_t> resample_styles(const world::Level& level, const world::Face& face,
                                         const SampleGrid& grid, const TileLight& light, std::size_t channels,
                                         base::Arena& arena) {
  const std::vector<std::uint8_t>& stored = channels == 3 ? level.light_rgb : level.light;
  const world::LightMapGrid& map = level.light_map_grids[face.light_map_grid];
  const std::size_t row_values = static_cast<std::size_t>(map.width) * channels;
  const std::size_t style_values = row_values * static_cast<std::size_t>(map.height);
  const std::span<std::uint32_t> sums = arena.allocate_filled<std::uint32_t>(
      static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns) * channels, 0);
  std::uint32_t* sum = sums.data();
  for (std::int32_t row = 0; row < grid.rows; ++row)
    for (std::int32_t column = 0; column < grid.columns; ++column, sum += channels) {
      const math::Vec2d position =
          map.position((grid.first_column + column) * grid.texels, (grid.first_row + row) * grid.texels);
      const BetweenSamples x = find_between(position.x, map.width), y = find_between(position.y, map.height);
      const std::uint8_t* samples = stored.data() + face.light * channels;
      for (std::size_t style = 0; style < face.style_count; ++style, samples += style_values)
        for (std::size_t channel = 0; channel < channels; ++channel) {
          const std::uint64_t sample_q16 = interpolate_q16(samples + channel, row_values, channels, x, y);
          sum[channel] += static_cast<std::uint32_t>(sample_q16 * light.style_values[style] >> 16);
        }
    }
  return sums;
}

std::span<std::uint32_t> in_three_channels(std::span<const std::uint32_t> gray, base::Arena& arena) {
  const std::span<std::uint32_t> sums = arena.allocate<std::uint32_t>(gray.size() * 3);
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = gray[i / 3];
  return sums;
}

// Scales samples whose brightest channel exceeds full light, so that their hue stays.
void limit_to_full_light(std::span<std::uint32_t> io_sums) {
  for (auto sum = io_sums.begin(); sum != io_sums.end(); sum += 3) {
    const std::uint32_t brightest = std::max({sum[0], sum[1], sum[2]});
    if (brightest <= kFullLight) continue;
    for (int channel = 0; channel < 3; ++channel)
      sum[channel] = static_cast<std::uint32_t>(std::uint64_t{sum[channel]} * kFullLight / brightest);
  }
}

void add_light(const FaceLight& light, const SampleGrid& grid, std::size_t channels,
               std::span<std::uint32_t> io_sums) {
  std::uint32_t* sum = io_sums.data();
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    const auto t = static_cast<float>((grid.first_row + row) * grid.texels);
    for (std::int32_t column = 0; column < grid.columns; ++column, sum += channels) {
      const auto s = static_cast<float>((grid.first_column + column) * grid.texels);
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

SampleGrid sample_grid(const world::Face& face, int tile_s, int tile_t, std::int32_t texels) {
  const auto count = [&](std::int32_t extent, int tile) {
    return std::min(extent - tile * kTileTexels, kTileTexels) / texels + 1;
  };
  const std::int32_t samples_per_tile = kTileTexels / texels;
  return {tile_s * samples_per_tile, tile_t * samples_per_tile, count(face.texture_extents[0], tile_s),
          count(face.texture_extents[1], tile_t), texels};
}

std::int32_t choose_sample_texels(const world::Level& level, const world::Face& face, int mip) {
  if (face.light_map_grid == world::kStockGrid) return kTexelsASample;
  return std::max(level.light_map_grids[face.light_map_grid].texels, std::int32_t{1} << std::max(mip, 0));
}

LightSums sum_light(const world::Level& level, const world::Face& face, const SampleGrid& grid,
                    const TileLight& light, base::Arena& arena) {
  std::size_t channels = light.colored ? 3 : 1;
  const bool is_stock = face.light_map_grid == world::kStockGrid;
  std::span<std::uint32_t> sums = is_stock ? sum_styles(level, face, grid, light, channels, arena)
                                           : resample_styles(level, face, grid, light, channels, arena);
  if (channels == 3) limit_to_full_light(sums);
  if (channels == 1 && std::any_of(light.lights.begin(), light.lights.end(), has_color)) {
    sums = in_three_channels(sums, arena);
    channels = 3;
  }
  for (const FaceLight& one : light.lights) add_light(one, grid, channels, sums);
  return {sums, channels};
}

}  // namespace temblor::render
