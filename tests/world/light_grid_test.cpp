// The light of a level's grid, compared with the definition: weights times samples.
#include <gtest/gtest.h>

#include <cmath>

#include "artgen/small_level.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/levels/small_bsp.h"
#include "support/random.h"
#include "world/sample_light.h"

namespace temblor::test {
namespace {

constexpr int kSide = 5;

// A grid of one leaf with random samples; every fourth is occluded.
formats::LightGrid make_random_grid(std::uint64_t seed, math::Vec3 mins, math::Vec3 step) {
  Random random(seed);
  formats::LightGrid grid;
  grid.mins = mins;
  grid.step = step;
  grid.size = {kSide, kSide, kSide};
  grid.root.value = formats::GridChild::kLeafBit;
  grid.leaves.push_back({{0, 0, 0}, grid.size, 0});
  const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const auto first = static_cast<std::uint32_t>(grid.lights.size());
    if (random.below(4) == 0) {
      grid.samples.push_back({first, formats::GridSample::kOccluded});
      continue;
    }
    grid.samples.push_back({first, 2});
    grid.lights.push_back({0, {byte(), byte(), byte()}});
    grid.lights.push_back({7, {byte(), byte(), byte()}});
  }
  return grid;
}

// The mean of all samples, weighted by hats of the grid's step around them.
std::optional<math::Vec3d> find_mean(const formats::LightGrid& grid, const world::LightStyleValues& styles,
                                     const math::Vec3& point) {
  math::Vec3d sum(0.0);
  double weights = 0;
  const math::Vec3d in_steps = (math::Vec3d(point) - math::Vec3d(grid.mins)) / math::Vec3d(grid.step);
  const auto hat = [](double off) { return std::max(0.0, 1 - std::abs(off)); };
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y)
      for (int z = 0; z < kSide; ++z) {
        const double weight = hat(in_steps.x - x) * hat(in_steps.y - y) * hat(in_steps.z - z);
        const auto& sample = grid.samples[static_cast<std::size_t>(x + kSide * (y + kSide * z))];
        if (weight <= 0 || sample.light_count == formats::GridSample::kOccluded) continue;
        for (std::uint32_t i = 0; i < sample.light_count; ++i) {
          const formats::GridLight& light = grid.lights[sample.first_light + i];
          for (int channel = 0; channel < 3; ++channel)
            sum[channel] += weight * light.rgb[static_cast<std::size_t>(channel)] * styles[light.style] / 256;
        }
        weights += weight;
      }
  if (weights < 1e-3) return std::nullopt;
  return sum / weights;
}

std::shared_ptr<const world::Level> level_with_grid(const formats::LightGrid& grid) {
  formats::Bsp bsp = small_bsp({});
  bsp.bspx.push_back({formats::kLightGridLump, formats::write_light_grid(grid)});
  return world::make_level(std::move(bsp), "level with a grid").value();
}

TEST(LightGridSampling, IsTheWeightedMeanOfOpenSamples) {
  world::LightStyleValues styles = world::make_stored_light_styles();
  styles[0] = 300;
  styles[7] = 100;
  int compared = 0;
  for (int seed = 0; seed < effort(40, 4); ++seed) {
    const formats::LightGrid grid =
        make_random_grid(static_cast<std::uint64_t>(seed), {-30, 5, -64}, {32, 16, 40});
    const auto level = level_with_grid(grid);
    ASSERT_TRUE(level->light_grid.has_value());
    Random random(static_cast<std::uint64_t>(seed) + 1000);
    for (int i = 0; i < 200; ++i) {
      const math::Vec3 point(
          math::Vec3d(random.uniform(-40, 110), random.uniform(0, 80), random.uniform(-80, 110)));
      const auto expected = find_mean(grid, styles, point);
      if (!expected) continue;
      ++compared;
      const world::PointLight light = world::sample_light(*level, styles, point);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(light.rgb[channel], (*expected)[channel], 0.05) << "seed " << seed;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(LightGridSampling, TakesTheFloorWhereTheGridHasNothing) {
  const DrawableLevel plain = small_level();
  formats::LightGrid grid = make_random_grid(1, math::Vec3(0.0f), math::Vec3(32.0f));
  for (formats::GridSample& sample : grid.samples) sample.light_count = formats::GridSample::kOccluded;
  const auto styles = world::make_stored_light_styles();
  const auto occluded = level_with_grid(grid),
             far = level_with_grid(make_random_grid(1, math::Vec3(1e6f), math::Vec3(32.0f)));
  for (int seed = 0; seed < 100; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const math::Vec3 point(
        math::Vec3d(random.uniform(-200, 200), random.uniform(-200, 200), random.uniform(-64, 200)));
    const world::PointLight floor = world::sample_light(*plain.level, styles, point);
    EXPECT_EQ(world::sample_light(*occluded, styles, point), floor);
    EXPECT_EQ(world::sample_light(*far, styles, point), floor);
  }
}

TEST(LightGridSampling, HasGrayOfTheStrongestChannel) {
  formats::LightGrid grid = make_random_grid(1, math::Vec3(0.0f), math::Vec3(32.0f));
  for (std::size_t i = 0; i < grid.lights.size(); ++i)
    grid.lights[i].rgb =
        i % 2 == 0 ? std::array<std::uint8_t, 3>{10, 90, 30} : std::array<std::uint8_t, 3>{7, 5, 2};
  const auto level = level_with_grid(grid);
  world::LightStyleValues styles = world::make_stored_light_styles();
  styles[0] = styles[7] = 256;
  const world::PointLight light = world::sample_light(*level, styles, {50, 60, 70});
  EXPECT_NEAR(light.gray, 97, 0.01);
  EXPECT_NEAR(light.rgb.x, 17, 0.01);
}

TEST(LightGridSampling, ADamagedGridIsLeftOutWithANote) {
  formats::Bsp bsp = small_bsp({});
  bsp.bspx.push_back({formats::kLightGridLump, base::ByteVector(50)});
  const auto level = world::make_level(std::move(bsp), "level with a damaged grid").value();
  EXPECT_FALSE(level->light_grid.has_value());
  ASSERT_EQ(level->notes.size(), 1u);
  EXPECT_NE(level->notes[0].find("LIGHTGRID_OCTREE"), std::string::npos) << level->notes[0];
}

TEST(LightGridSampling, PlacesThatAreNoNumbersDoNoHarm) {
  const auto level = level_with_grid(make_random_grid(3, math::Vec3(0.0f), math::Vec3(32.0f)));
  const auto styles = world::make_stored_light_styles();
  for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1e30f})
    EXPECT_EQ(world::sample_light(*level, styles, {bad, 0, 0}).gray, 0);
}

}  // namespace
}  // namespace temblor::test
