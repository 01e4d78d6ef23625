// Grids of light in open space, compared with the formulas of lights and with the level's own leaves.
#include "compiler/light/grid/light_grid.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "artgen/small_level.h"
#include "compiler/light/lighting.h"
#include "support/effort.h"
#include "support/random.h"
#include "world/sample_light.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using GridPlace = std::array<std::int32_t, 3>;

compiler::LightOptions with_grid(float step = 32) {
  compiler::LightOptions options;
  options.grid_step = math::Vec3(step);
  return options;
}

formats::LightGrid read_grid(const formats::Bsp& bsp) {
  const formats::BspxLump* lump = bsp.find_bspx(formats::kLightGridLump);
  CHECK(lump != nullptr, "no light grid");
  return formats::read_light_grid(lump->data).value();
}

// Calls visit(place_world, lights) for each sample.
template <typename Visit>
void visit_samples(const formats::LightGrid& grid, const Visit& visit) {
  for (std::int32_t z = 0; z < grid.size[2]; ++z)
    for (std::int32_t y = 0; y < grid.size[1]; ++y)
      for (std::int32_t x = 0; x < grid.size[0]; ++x)
        visit(math::Vec3d(grid.mins) + math::Vec3d(grid.step) * math::Vec3d(x, y, z),
              formats::find_grid_lights(grid, {x, y, z}));
}

// Only the samples in open space. Returns their number.
template <typename Visit>
int visit_open_samples(const formats::LightGrid& grid, const Visit& visit) {
  int count = 0;
  visit_samples(grid, [&](const math::Vec3d& place, const auto& lights) {
    if (!lights) return;
    visit(place, *lights);
    ++count;
  });
  return count;
}

double gray(std::span<const formats::GridLight> lights, std::uint8_t style = 0) {
  for (const formats::GridLight& light : lights)
    if (light.style == style) return *std::max_element(light.rgb.begin(), light.rgb.end());
  return 0;
}

// Half of a light's value is stored, and a surface with the default _anglescale gets 3/4 of it on average.
TEST(LightGridOfALevel, FollowsTheFormulaOfALight) {
  const LitResult lit =
      light(room_with({"{ 'classname' 'light' 'origin' '10 -20 5' 'light' '300' }"}), with_grid(16));
  const int compared = visit_open_samples(read_grid(lit.bsp), [&](const math::Vec3d& place, auto lights) {
    const double distance = glm::distance(place, math::Vec3d(10, -20, 5));
    EXPECT_NEAR(gray(lights), std::max(0.0, 300 - distance) * 0.75 / 2, 1) << distance;
  });
  EXPECT_EQ(compared, 8 * 8 * 8);
}

// Models of other files are on channel 1; a projector along x lights only what is ahead of it.
TEST(LightGridOfALevel, KnowsChannelsAndPictures) {
  const auto grid_with = [](const char* keys, const char* world_keys = "") {
    const LitResult lit =
        light(room_with({fmt::format("{{ 'classname' 'light' 'origin' '0 0 0' 'light' '300' {} }}", keys),
                         world_keys}),
              with_grid());
    EXPECT_TRUE(lit.warnings.empty());
    return read_grid(lit.bsp);
  };
  const auto find_brightest = [](const formats::LightGrid& grid, double sign_x) {
    double brightest = 0;
    visit_open_samples(grid, [&](const math::Vec3d& place, auto lights) {
      if (place.x * sign_x > 0) brightest = std::max(brightest, gray(lights));
    });
    return brightest;
  };
  EXPECT_GT(find_brightest(grid_with("'_light_channel_mask' '3'"), 1), 50);
  EXPECT_EQ(find_brightest(grid_with("'_light_channel_mask' '2'", "'_minlight' '20'"), 1), 10);
  const formats::LightGrid projected = grid_with("'_project_texture' 'wall' '_project_mangle' '0 0 0'");
  EXPECT_GT(find_brightest(projected, 1), 20);
  EXPECT_EQ(find_brightest(projected, -1), 0);
  EXPECT_NEAR(find_brightest(grid_with("", "'_minlight' '20' '_addmin' '1'"), 1),
              find_brightest(grid_with(""), 1) + 10, 1);
}

TEST(LightGridOfALevel, HasColorsStylesAndMinimumLight) {
  const LitResult lit = light(
      room_with(
          {"{ 'classname' 'light' 'origin' '0 0 0' 'light' '200' 'delay' '3' '_color' '1 0.5 0' 'style' '3' }"
           "{ 'classname' 'light' 'origin' '0 0 0' 'light' '-20' 'delay' '3' '_anglescale' '0' }",
           "'_minlight' '100'"}),
      with_grid());
  const int compared = visit_open_samples(read_grid(lit.bsp), [&](const math::Vec3d&, auto lights) {
    const std::vector<formats::GridLight> expected = {{0, {40, 40, 40}}, {3, {75, 38, 0}}};
    EXPECT_EQ(std::vector(lights.begin(), lights.end()), expected);
  });
  EXPECT_EQ(compared, 4 * 4 * 4);
}

// All luxels get 180 from a light without angle, so each ray brings the same.
TEST(LightGridOfALevel, AddsTheFirstBounce) {
  const auto room =
      room_with({"{ 'classname' 'light' 'origin' '0 0 0' 'light' '80' 'delay' '3' '_anglescale' '0' }",
                 "'_bounce' '1'"});
  const formats::LightGrid grid = read_grid(light(room, with_grid()).bsp);
  constexpr double kGrayShare = 1.5 * 127 / 255;  // of light that a gray wall sends back
  const int compared = visit_open_samples(grid, [&](const math::Vec3d&, auto lights) {
    EXPECT_NEAR(gray(lights), (80 + 80 * kGrayShare) / 2, 1);
  });
  EXPECT_EQ(compared, 4 * 4 * 4);
}

TEST(LightGridOfALevel, TakesTheSun) {
  const LitResult lit =
      light(room_with({.world_keys = "'_sunlight' '120' '_sun_mangle' '0 -90 0'", .sky = true}), with_grid());
  const int compared = visit_open_samples(read_grid(lit.bsp), [&](const math::Vec3d&, auto lights) {
    EXPECT_NEAR(gray(lights), 120 * 0.75 / 2, 1);
  });
  EXPECT_EQ(compared, 4 * 4 * 4);
}

TEST(LightGridOfALevel, IsOpenWhereTheLevelIs) {
  const formats::Bsp unlit = artgen::make_small_level({});
  const LitResult lit = light(unlit, with_grid(16));
  const auto level = world::make_level(lit.bsp, "lit").value();
  ASSERT_TRUE(level->light_grid.has_value());
  int open = 0, solid = 0;
  visit_samples(*level->light_grid, [&](const math::Vec3d& place, const auto& lights) {
    const world::Contents contents = world::point_contents(*level, math::Vec3(place));
    const bool is_open = contents != world::Contents::kSolid && contents != world::Contents::kSky;
    ASSERT_EQ(lights.has_value(), is_open);
    ++(is_open ? open : solid);
  });
  EXPECT_GT(open, 100);
  EXPECT_GT(solid, 100);
}

TEST(LightGridOfALevel, StopsAtWalls) {
  const LitResult lit = light(artgen::make_small_level({}), with_grid(16));
  const auto level = world::make_level(lit.bsp, "lit").value();
  // A point that no light of the level can see directly has only minimum light, of which there is none.
  int dark = 0, bright = 0;
  visit_samples(*level->light_grid, [&](const math::Vec3d&, const auto& lights) {
    if (lights) ++(lights->empty() ? dark : bright);
  });
  EXPECT_GT(dark, 0);
  EXPECT_GT(bright, 0);
}

TEST(LightGridOfALevel, DoesNotDependOnThreads) {
  formats::Bsp bsp = artgen::make_small_level({});
  auto entities = formats::read_entities(bsp.entities).value();
  for (const char* key : {"_bounce", "_sunlight", "_sunlight2"}) entities[0].pairs.emplace_back(key, "50");
  bsp.entities = formats::write_entities(entities);
  const LitResult one = light(bsp, with_grid(24), 1);
  for (const int threads : {2, effort(8, 3)})
    EXPECT_EQ(one.bsp.bspx, light(bsp, with_grid(24), threads).bsp.bspx) << threads << " threads";
}

TEST(LightGridOfALevel, LeavesAllOtherLightAsItIs) {
  const formats::Bsp unlit = artgen::make_small_level({});
  const formats::Bsp plain = light(unlit).bsp;
  formats::Bsp with = light(unlit, with_grid()).bsp;
  EXPECT_NE(with.find_bspx(formats::kLightGridLump), nullptr);
  EXPECT_EQ(light(with).bsp, plain) << "the grid is removed again";
  std::erase_if(with.bspx,
                [](const formats::BspxLump& lump) { return lump.name == formats::kLightGridLump; });
  EXPECT_EQ(with, plain);
}

TEST(LightGridOfALevel, IsLeftOutIfItWouldBeHuge) {
  const LitResult lit = light(room_with({}), with_grid(0.25f));
  EXPECT_EQ(lit.bsp.find_bspx(formats::kLightGridLump), nullptr);
  ASSERT_EQ(lit.warnings.size(), 1u);
  EXPECT_EQ(lit.warnings[0].kind, "no light grid");
}

TEST(LightGridOctree, HoldsEverySampleOfRandomBlocks) {
  for (int seed = 0; seed < effort(60, 10); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    compiler::GridBlocks blocks;
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      blocks.size[axis] = 1 + static_cast<std::int32_t>(random.below(30));
      blocks.blocks[axis] = (blocks.size[axis] + compiler::kBlockSide - 1) / compiler::kBlockSide;
      count *= static_cast<std::size_t>(blocks.blocks[axis]);
    }
    blocks.of_place.resize(count);
    const double open_share = random.uniform(0, 1);
    for (compiler::GridBlock& block : blocks.of_place) {
      if (random.chance(0.4)) continue;
      for (std::size_t i = 0; i < compiler::GridBlock::kSamples; ++i) {
        const auto first = static_cast<std::uint32_t>(block.lights.size());
        if (!random.chance(open_share)) {
          block.samples.push_back({first, formats::GridSample::kOccluded});
          continue;
        }
        block.samples.push_back({first, 1});
        block.lights.push_back({0, {static_cast<std::uint8_t>(random.below(256)), 0, 0}});
      }
    }
    const auto grid =
        formats::read_light_grid(formats::write_light_grid(compiler::make_octree(blocks))).value();
    ASSERT_EQ(grid.size, blocks.size);
    for (std::int32_t z = 0; z < grid.size[2]; ++z)
      for (std::int32_t y = 0; y < grid.size[1]; ++y)
        for (std::int32_t x = 0; x < grid.size[0]; ++x) {
          const GridPlace place{x, y, z};
          const compiler::GridBlock& block = blocks.block_at(place);
          const auto found = formats::find_grid_lights(grid, place);
          const bool is_open = !block.samples.empty() &&
                               block.samples[compiler::GridBlocks::number_in_block(place)].light_count == 1;
          ASSERT_EQ(found.has_value(), is_open) << "seed " << seed;
          if (!is_open) continue;
          const formats::GridSample& sample = block.samples[compiler::GridBlocks::number_in_block(place)];
          ASSERT_EQ((*found)[0], block.lights[sample.first_light]) << "seed " << seed;
        }
  }
}

}  // namespace
}  // namespace temblor::test
