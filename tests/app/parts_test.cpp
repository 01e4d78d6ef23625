// Unit tests of the program's own parts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <new>
#include <set>

#include "app/bench/allocation_counter.h"
#include "app/bench/distribution.h"
#include "app/bench/fill_baseline.h"
#include "app/commands/options.h"
#include "app/files/picture_file.h"
#include "app/files/progress.h"
#include "app/level/level_scene.h"
#include "app/level/viewpoints.h"
#include "artgen/small_level.h"
#include "support/random.h"

namespace temblor::app {
namespace {

using ::testing::ElementsAre;

TEST(ParseSize, TakesWidthAndHeight) {
  const FrameSize size = parse_size("8192x1").value();
  EXPECT_EQ(size.width, 8192);
  EXPECT_EQ(size.height, 1);
  for (const char* wrong : {"", "x", "1x", "x1", "1x0", "-1x1", "1x8193", "1x1x1", "1 x1", "1X1", "1.5x2"})
    EXPECT_FALSE(parse_size(wrong).ok()) << wrong;
}

TEST(ParseVec3, TakesThreeNumbers) {
  EXPECT_EQ(parse_vec3("1,-2.5,3e2").value(), math::Vec3(1.0f, -2.5f, 300.0f));
  for (const char* wrong :
       {"", "1", "1,2", "1,2,3,4", "1,2,", ",,", "a,b,c", "1,2,inf", "1, 2,3", "1e99,0,0"})
    EXPECT_FALSE(parse_vec3(wrong).ok()) << wrong;
}

TEST(ParseFrameRange, TakesACountOrARange) {
  const auto range = [](const char* text) {
    const FrameRange parsed = parse_frame_range(text).value();
    return std::pair(parsed.first, parsed.end);
  };
  EXPECT_EQ(range("7"), std::pair(std::size_t{0}, std::size_t{7}));
  EXPECT_EQ(range("3:5"), std::pair(std::size_t{3}, std::size_t{5}));
  EXPECT_EQ(range(":5"), std::pair(std::size_t{0}, std::size_t{5}));
  EXPECT_EQ(range("3:"), std::pair(std::size_t{3}, kMaxFrames));
  for (const char* wrong :
       {"", ":", "0", "5:5", "6:5", "-1", "1:-1", "1.5", "a", "1:2:3", "1 :2", "99999999999"})
    EXPECT_FALSE(parse_frame_range(wrong).ok()) << wrong;
}

TEST(DescribeProgress, ShowsProgressAndTimeLeft) {
  EXPECT_EQ(describe_progress("frames", 0, 40, 0), "frames: [....................] 0 of 40");
  EXPECT_EQ(describe_progress("frames", 10, 40, 5), "frames: [#####...............] 10 of 40, 15 s left");
  EXPECT_EQ(describe_progress("frames", 1, 100, 1.5),
            "frames: [....................] 1 of 100, 2 min 29 s left");
  EXPECT_EQ(describe_progress("frames", 40, 40, 9), "frames: [####################] 40 of 40, 0 s left");
}

TEST(NumberedName, InsertsTheNumber) {
  EXPECT_EQ(numbered_name("x.png", 7).value(), "x.png");
  EXPECT_EQ(numbered_name("x-%d.png", 7).value(), "x-7.png");
  EXPECT_EQ(numbered_name("a/x-%05d.PNG", 123).value(), "a/x-00123.PNG");
  EXPECT_EQ(numbered_name("%02d.png", 1234).value(), "1234.png");
  for (const char* wrong :
       {"x.jpg", "x", "%s.png", "%.png", "%d%d.png", "%-5d.png", "%99d.png", "100%.png", "%n.png"})
    EXPECT_FALSE(numbered_name(wrong, 1).ok()) << wrong;
}

TEST(Distribution, MatchesCounting) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    std::vector<double> values(1 + random.below(300));
    for (double& value : values) value = static_cast<double>(random.below(50));
    const Distribution result = compute_distribution(values);
    const auto share_up_to = [&](double limit) {
      return static_cast<double>(
                 std::count_if(values.begin(), values.end(), [&](double v) { return v <= limit; })) /
             static_cast<double>(values.size());
    };
    for (const auto& [percentile, share] : {std::pair(result.p50, 0.5), {result.p99, 0.99}}) {
      EXPECT_GE(share_up_to(percentile), share) << "seed " << seed;
      EXPECT_LT(share_up_to(percentile - 0.5), share)
          << "seed " << seed << ": a smaller value would be enough";
    }
    EXPECT_EQ(result.max, *std::max_element(values.begin(), values.end()));
  }
}

TEST(Distribution, IsZeroWithoutValues) {
  EXPECT_EQ(compute_distribution({}).max, 0);
  EXPECT_EQ(compute_mean({}), 0);
  EXPECT_EQ(compute_mean({1, 2, 6}), 3);
}

class FillBaseline : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Placements, FillBaseline, ::testing::Range(0, kBaselinePlacements));

TEST_P(FillBaseline, ReadsTheTexelsOfItsSteps) {
  constexpr int kWidth = 500, kHeight = 20;
  render::FrameBuffer frame(kWidth, kHeight, render::PixelFormat::kRgb);
  run_fill_baseline(GetParam(), frame);
  // Two pixels have the same color if and only if their texture coordinates fall on the same texel, because
  // all texels of the surface differ.
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> texels;
  std::set<std::uint32_t> colors;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::int64_t s = std::int64_t{x} * 40000 / 65536 % 256;
      const std::int64_t t = (y + std::int64_t{x} * 3000 / 65536) % 256;
      const std::uint32_t color = frame.rgb()[static_cast<std::size_t>(y * kWidth + x)];
      const auto [known, is_new] = texels.emplace(std::pair(s, t), color);
      ASSERT_EQ(known->second, color) << x << " " << y;
      colors.insert(color);
    }
  }
  EXPECT_EQ(colors.size(), texels.size());
}

TEST_P(FillBaseline, FillsIndexedFramesCompletely) {
  render::FrameBuffer frame(300, 7, render::PixelFormat::kIndexed);
  std::fill(frame.indexed().begin(), frame.indexed().end(), std::uint8_t{7});
  run_fill_baseline(GetParam(), frame);
  const std::vector<std::uint8_t> first(frame.indexed().begin(), frame.indexed().end());
  std::fill(frame.indexed().begin(), frame.indexed().end(), std::uint8_t{9});
  run_fill_baseline(GetParam(), frame);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), frame.indexed().begin()));
}

// Calls the functions themselves, since a compiler may leave out new expressions.
TEST(AllocationCounter, CountsEveryKindOfNew) {
  constexpr std::align_val_t kAlignment{128};
  const std::uint64_t before = allocation_count();
  void* const one = ::operator new(4);
  void* const many = ::operator new[](400);
  void* const aligned = ::operator new(128, kAlignment);
  void* const quiet = ::operator new(4, std::nothrow);
  EXPECT_EQ(allocation_count() - before, 4u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(aligned) % 128, 0u);
  ::operator delete(one);
  ::operator delete[](many);
  ::operator delete(aligned, kAlignment);
  ::operator delete(quiet, std::nothrow);
}

std::shared_ptr<const world::Level> level_with_entities(const std::string& entities) {
  formats::Bsp bsp = artgen::make_small_level();
  bsp.entities = entities;
  return world::make_level(std::move(bsp), "test").value();
}

TEST(Viewpoints, AreWherePlayersAppear) {
  const auto level = level_with_entities(R"({"classname" "worldspawn"}
    {"classname" "info_intermission" "origin" "1 2 3" "mangle" "10 20 30"}
    {"classname" "info_player_deathmatch" "origin" "5 5 5"}
    {"classname" "info_teleport_destination" "origin" "7 7 7" "angle" "45"}
    {"classname" "light" "origin" "9 9 9"}
    {"classname" "info_player_start" "origin" "4 5 6" "angle" "90"})");
  const Viewpoint start = find_start_viewpoint(*level);
  EXPECT_EQ(start.eye_world, math::Vec3(4, 5, 28));
  EXPECT_EQ(start.angles_deg, math::Vec3(0, 90, 0));
  const std::vector<Viewpoint> all = list_viewpoints(*level);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].eye_world, math::Vec3(1, 2, 3));
  EXPECT_EQ(all[0].angles_deg, math::Vec3(10, 20, 30));
  EXPECT_EQ(all[1].eye_world, math::Vec3(5, 5, 27));
  EXPECT_EQ(all[2].angles_deg, math::Vec3(0, 45, 0));
}

TEST(Viewpoints, LevelWithoutStartsIsSeenFromItsCenter) {
  const auto level = level_with_entities(R"({"classname" "worldspawn"})");
  const math::Bounds& bounds = level->world().bounds;
  EXPECT_EQ(find_start_viewpoint(*level).eye_world, (bounds.mins + bounds.maxs) / 2.0f);
  EXPECT_EQ(list_viewpoints(*level).size(), 1u);
}

TEST(LevelScene, ContainsTheVisibleBrushModels) {
  const LevelScene scene = make_level_scene(level_with_entities(R"({"classname" "worldspawn" "model" "*1"}
    {"classname" "func_door" "model" "*1" "origin" "1 2 3"}
    {"classname" "func_wall" "model" "*1"}
    {"classname" "trigger_once" "model" "*1"}
    {"classname" "func_episodegate" "model" "*1"}
    {"classname" "func_wall" "model" "*0"}
    {"classname" "func_wall" "model" "*2"}
    {"classname" "func_wall" "model" "*1x"}
    {"classname" "func_wall" "model" "*99999999999"}
    {"classname" "misc_model" "model" "progs/player.mdl"})"));
  std::vector<math::Vec3> origins;
  for (const render::BrushModelInstance& instance : scene.brush_models) {
    EXPECT_EQ(instance.model, world::ModelIndex{1});
    origins.push_back(instance.origin_world);
  }
  EXPECT_THAT(origins, ElementsAre(math::Vec3(0.0f), math::Vec3(1, 2, 3), math::Vec3(0.0f)));
}

TEST(LevelScene, SwitchedLightsStartAsTheMapperWants) {
  const LevelScene scene = make_level_scene(level_with_entities(R"({"classname" "worldspawn"}
    {"classname" "light" "targetname" "a" "style" "32"}
    {"classname" "light_torch" "targetname" "b" "style" "33" "spawnflags" "1"}
    {"classname" "light" "style" "34" "spawnflags" "1"}
    {"classname" "light" "targetname" "d" "style" "35" "spawnflags" "513"}
    {"classname" "light" "targetname" "e" "style" "2" "spawnflags" "1"}
    {"classname" "light" "targetname" "f" "style" "64" "spawnflags" "1"})"));
  world::LightStylePatterns expected = world::make_standard_light_styles();
  expected[32] = "m";
  expected[33] = "a";
  EXPECT_EQ(scene.light_styles, expected);
}

}  // namespace
}  // namespace temblor::app
