// Light maps of other resolutions, turned any way, against the definition: linear interpolation between the
// four samples around a texel, in real numbers.
#include "render/surfaces/light/light_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "render/edges/face_outlines.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

// A face of 300 x 200 texels, rounded up, in four tiles or fewer.
world::Level make_level(const world::LightMapGrid& grid, const std::function<double(int, int)>& light) {
  world::Level level;
  level.has_light = true;
  level.light_map_grids.push_back(grid);
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.light_map_grid = 0;
  face.style_count = 1;
  face.styles = {0, world::kNoStyle, world::kNoStyle, world::kNoStyle};
  face.texture_extents = {304, 208};
  level.faces.push_back(face);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      level.light.push_back(static_cast<std::uint8_t>(std::lround(light(x, y))));
  return level;
}

// A grid that covers the face, turned by `angle`, with `per_texel` samples for each texel.
world::LightMapGrid make_turned_grid(double angle, double per_texel) {
  world::LightMapGrid grid{};
  grid.per_s = math::Vec2d(std::cos(angle), std::sin(angle)) * per_texel;
  grid.per_t = math::Vec2d(-std::sin(angle), std::cos(angle)) * per_texel;
  math::Vec2d low(1e9), high(-1e9);
  for (const double s : {0.0, 304.0})
    for (const double t : {0.0, 208.0}) {
      low = glm::min(low, grid.position(s, t));
      high = glm::max(high, grid.position(s, t));
    }
  grid.first -= glm::floor(low);
  const math::Vec2d size = glm::ceil(high - glm::floor(low)) + 1.0;
  grid.width = static_cast<int>(size.x);
  grid.height = static_cast<int>(size.y);
  grid.texels = 1;
  return grid;
}

render::TileLight as_stored() {
  render::TileLight light;
  light.style_values = {256, 0, 0, 0};
  return light;
}

// The level's light at a position of the grid, by definition.
double interpolate(const world::Level& level, const math::Vec2d& at) {
  const world::LightMapGrid& grid = level.light_map_grids[0];
  const double x = std::clamp(at.x, 0.0, grid.width - 1.0), y = std::clamp(at.y, 0.0, grid.height - 1.0);
  const auto sample = [&](double column, double row) {
    const auto u = static_cast<std::size_t>(std::min(column, grid.width - 1.0));
    const auto v = static_cast<std::size_t>(std::min(row, grid.height - 1.0));
    return static_cast<double>(level.light[v * static_cast<std::size_t>(grid.width) + u]);
  };
  const double left = std::floor(x), top = std::floor(y);
  return std::lerp(std::lerp(sample(left, top), sample(left + 1, top), x - left),
                   std::lerp(sample(left, top + 1), sample(left + 1, top + 1), x - left), y - top);
}

TEST(LightSamples, OfTurnedMapsAreInterpolated) {
  base::Arena arena;
  for (int seed = 0; seed < effort(40, 5); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const world::LightMapGrid grid = make_turned_grid(random.uniform(0, 7), random.log_uniform(0.02, 1));
    const world::Level level = make_level(grid, [&](int, int) { return random.uniform(0, 255); });
    for (const int tile_s : {0, 1}) {
      arena.reset();
      const render::SampleGrid samples = render::sample_grid(level.faces[0], tile_s, 0, 1);
      const render::LightSums sums = render::sum_light(level, level.faces[0], samples, as_stored(), arena);
      ASSERT_EQ(sums.channels, 1u);
      for (int row = 0; row < samples.rows; row += 7)
        for (int column = 0; column < samples.columns; ++column) {
          const double expected = interpolate(level, grid.position(tile_s * 256 + column, row));
          // A position is off by up to 1/512 of a sample along both axes.
          ASSERT_NEAR(sums.values[static_cast<std::size_t>(row * samples.columns + column)] / 256.0, expected,
                      255.0 / 256 + 0.01)
              << "seed " << seed << ", tile " << tile_s << ": " << column << ", " << row;
        }
    }
  }
}

// The coarser lattice that the loader chooses for a turned map shows a linear gradient as it is.
TEST(LightSamples, OfGradientsAreOnTheGradient) {
  base::Arena arena;
  for (int seed = 0; seed < effort(40, 5); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    world::LightMapGrid grid = make_turned_grid(random.uniform(0, 7), random.log_uniform(0.02, 0.2));
    grid.texels = 1 << random.below(5);
    const world::Level level =
        make_level(grid, [&](int x, int y) { return 250.0 * (x + y) / (grid.width + grid.height); });
    for (int mip = 0; mip < 4; ++mip) {
      const int texels = render::choose_sample_texels(level, level.faces[0], mip);
      ASSERT_EQ(texels, std::max(grid.texels, 1 << mip));
      arena.reset();
      const render::SampleGrid samples = render::sample_grid(level.faces[0], 0, 0, texels);
      const render::LightSums sums = render::sum_light(level, level.faces[0], samples, as_stored(), arena);
      for (int row = 0; row < samples.rows; ++row)
        for (int column = 0; column < samples.columns; ++column) {
          const math::Vec2d at = grid.position(column * texels, row * texels);
          ASSERT_NEAR(sums.values[static_cast<std::size_t>(row * samples.columns + column)] / 256.0,
                      250.0 * (at.x + at.y) / (grid.width + grid.height), 1)
              << "seed " << seed << ", mip " << mip;
        }
    }
  }
}

// The last column of a tile's samples is the first one of the next tile's.
TEST(LightSamples, OfAdjacentTilesAgreeOnTheirSeam) {
  base::Arena arena;
  for (int seed = 0; seed < effort(100, 10); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    world::LightMapGrid grid = make_turned_grid(random.uniform(0, 7), random.log_uniform(0.02, 1));
    grid.texels = 1 << random.below(5);
    const world::Level level = make_level(grid, [&](int, int) { return random.uniform(0, 255); });
    const render::FaceLight lamp{250, 90, 1, 1, 200, 180, {1, 1, 1}};
    render::TileLight light = as_stored();
    light.lights = {&lamp, 1};
    const world::Face& face = level.faces[0];
    const int texels = render::choose_sample_texels(level, face, static_cast<int>(random.below(4)));
    arena.reset();
    const render::SampleGrid left = render::sample_grid(face, 0, 0, texels),
                             right = render::sample_grid(face, 1, 0, texels);
    const render::LightSums left_sums = render::sum_light(level, face, left, light, arena),
                            right_sums = render::sum_light(level, face, right, light, arena);
    ASSERT_EQ(left.rows, right.rows);
    for (int row = 0; row < left.rows; ++row)
      ASSERT_EQ(left_sums.values[static_cast<std::size_t>((row + 1) * left.columns - 1)],
                right_sums.values[static_cast<std::size_t>(row * right.columns)])
          << "seed " << seed << ", row " << row;
  }
}

// Between the samples of a fine lattice, dynamic light is computed, not interpolated.
TEST(LightSamples, HaveDynamicLightWhereTheyAre) {
  world::LightMapGrid grid = make_turned_grid(0, 0.25);
  grid.texels = 4;
  const world::Level level = make_level(grid, [](int, int) { return 0.0; });
  const render::FaceLight lamp{33, 21, 1, 1, 100, 90, {1, 1, 1}};
  render::TileLight light = as_stored();
  light.lights = {&lamp, 1};
  base::Arena arena;
  const render::SampleGrid samples = render::sample_grid(level.faces[0], 0, 0, 4);
  ASSERT_EQ(samples.columns, 65);
  ASSERT_EQ(samples.rows, 53);
  const render::LightSums sums = render::sum_light(level, level.faces[0], samples, light, arena);
  const auto light_at = [&](int s, int t) {
    return sums.values[static_cast<std::size_t>(t / 4 * 65 + s / 4)] / 256.0;
  };
  EXPECT_DOUBLE_EQ(light_at(32, 20), 100 - 1.5);
  EXPECT_DOUBLE_EQ(light_at(36, 20), 100 - 3.5);
  EXPECT_DOUBLE_EQ(light_at(36, 40), 100 - 20.5);
  EXPECT_DOUBLE_EQ(light_at(200, 20), 0);
}

}  // namespace
}  // namespace temblor::test
