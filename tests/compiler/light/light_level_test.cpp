// Whole levels: the same bytes however they are made, styles, seams, and the contents of the result.
#include "compiler/light/light_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "artgen/small_level.h"
#include "compiler/light/lighting.h"
#include "formats/levels/bsp_validate.h"
#include "support/effort.h"
#include "support/levels/room_map.h"
#include "world/face_at.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

// All kinds of light at once, in the level made in code, which has a court under the sky.
formats::Bsp small_level_with_all() {
  artgen::SmallLevelOptions options;
  options.light = false;
  formats::Bsp bsp = artgen::make_small_level(options);
  auto entities = formats::read_entities(bsp.entities).value();
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"_sunlight", "150"},
                                                                  {"_sun_mangle", "40 -60 0"},
                                                                  {"_sunlight2", "80"},
                                                                  {"_sunlight2_color", "150 180 255"},
                                                                  {"_dirt", "1"},
                                                                  {"_bounce", "2"}})
    entities[0].pairs.emplace_back(key, value);
  bsp.entities = formats::write_entities(entities);
  return bsp;
}

// Not in the thread sanitizer's list: it reports Embree's own workers, which are not instrumented, as races.
TEST(LightLevel, DoesNotDependOnThreads) {
  const formats::Bsp unlit = small_level_with_all();
  const LitResult one = light(unlit);
  EXPECT_TRUE(one.summary.colored);
  for (const int threads : {1, 2, effort(8, 3)}) {
    const LitResult other = light(unlit, {}, threads);
    EXPECT_EQ(one.bsp, other.bsp) << threads << " threads";
    EXPECT_EQ(one.summary.lit, other.summary.lit) << threads << " threads";
  }
}

TEST(LightLevel, ResultIsValidAndCanBeRelit) {
  const LitResult once = light(small_level_with_all());
  EXPECT_FALSE(formats::find_fault(once.bsp).has_value());
  ASSERT_TRUE(world::make_level(once.bsp, "lit").ok());
  EXPECT_EQ(once.bsp.lighting.size(), once.summary.samples);
  const formats::BspxLump* colored = once.bsp.find_bspx("RGBLIGHTING");
  ASSERT_NE(colored, nullptr);
  EXPECT_EQ(base::as_u8(colored->data).size(), 3 * once.bsp.lighting.size());
  EXPECT_EQ(light(once.bsp).bsp, once.bsp);
}

TEST(LightLevel, PvsOnlySavesRays) {
  formats::Bsp with = small_level_with_all(), without = with;
  ASSERT_FALSE(with.visibility.empty());
  without.visibility.clear();
  for (formats::BspLeaf& leaf : without.leaves) leaf.visibility_offset = -1;
  EXPECT_EQ(light(with).bsp.lighting, light(without).bsp.lighting);
}

TEST(LightLevel, ExtraSamplesOnlyRefineShadows) {
  const LitResult plain = light(small_level_with_all());
  const auto mean = [](const formats::Bsp& bsp) {
    double sum = 0;
    for (const std::uint8_t sample : bsp.lighting) sum += sample;
    return sum / static_cast<double>(bsp.lighting.size());
  };
  for (const int extra : {2, 4}) {
    const LitResult finer = light(small_level_with_all(), {.extra = extra});
    EXPECT_EQ(finer.summary.lit_faces, plain.summary.lit_faces) << extra;
    ASSERT_EQ(finer.bsp.lighting.size(), plain.bsp.lighting.size()) << extra;
    EXPECT_NE(finer.bsp.lighting, plain.bsp.lighting) << extra;
    EXPECT_NEAR(mean(finer.bsp), mean(plain.bsp), 0.5) << extra;
  }
}

TEST(LightLevel, StoppingLeavesTheLevelUnchanged) {
  formats::Bsp bsp = small_level_with_all();
  const formats::Bsp before = bsp;
  const auto keys = compiler::find_face_keys(bsp, formats::read_entities(bsp.entities).value());
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  compiler::Warnings warnings;
  const auto result = compiler::light_level(
      bsp, keys, {}, jobs, [](std::size_t done, std::size_t) { return done < 3; }, warnings);
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(bsp, before);
}

TEST(LightLevel, SwitchableLightsGetStylesInTheOrderOfTheirNames) {
  const LitResult lit =
      light(room_with({"{ 'classname' 'light' 'origin' '0 0 0' 'targetname' 'b' }"
                       "{ 'classname' 'light' 'origin' '9 0 0' 'targetname' 'a' }"
                       "{ 'classname' 'light' 'origin' '0 9 0' 'targetname' 'b' }"}));
  const auto entities = formats::read_entities(lit.bsp.entities).value();
  EXPECT_EQ(entities[1].find("style"), "32");
  EXPECT_EQ(entities[2].find("style"), "33");
  EXPECT_EQ(entities[3].find("style"), "32");
  EXPECT_EQ(lit.bsp.faces[0].styles, (std::array<std::uint8_t, 4>{32, 33, 255, 255}));
}

TEST(LightLevel, KeepsTheFourBrightestStyles) {
  std::string entities;
  for (int style = 1; style <= 6; ++style)
    entities += "{ 'classname' 'light' 'origin' '0 0 0' 'delay' '3' 'style' '" + std::to_string(style) +
                "' 'light' '" + std::to_string(style == 2 ? 190 : 100 - style * 10) + "' }";
  const LitResult lit = light(room_with({entities}));
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_EQ(lit.bsp.faces[face].styles, (std::array<std::uint8_t, 4>{1, 2, 3, 4}));
  ASSERT_EQ(lit.warnings.size(), 1u);
  EXPECT_NE(lit.warnings[0].what.find("12 styles"), std::string::npos);
}

TEST(LightLevel, SurfaceLightsMakeFacesShine) {
  // Every wall has the texture "wall"; the center of the room is equally far from all of them.
  const LitResult lit = light(
      room_with({"{ 'classname' 'light' '_surface' 'WALL' 'light' '40' 'delay' '2' '_color' '0 1 0' }"}));
  // The world's grid of 128 units cuts each of the six walls, which are 128 units wide, twice.
  EXPECT_EQ(lit.summary.lights, 24u);
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    EXPECT_EQ(luxel.rgb[0], 0);
    EXPECT_GT(luxel.rgb[1], 0);
  }
}

TEST(LightLevel, HiddenFacesOfDoorsHaveTheLightAtTheirCenter) {
  // It reaches from below the floor to above the ceiling, so its ends are dark.
  const LitResult lit =
      light(room_with({"{ 'classname' 'func_door' " + box_text({-8, -8, -72}, {8, 8, 72}, "door") + "}" +
                       "{ 'classname' 'light' 'origin' '0 0 30' 'delay' '3' '_anglescale' '1' }"}));
  int of_ends = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    if (luxel.of_world || luxel.normal.z == 0) continue;
    // One of six directions faces a light of 300 straight above.
    EXPECT_NEAR(luxel.gray, 300.0 / 6 / 2, 1) << luxel;
    ++of_ends;
  }
  EXPECT_EQ(of_ends, 2);
}

// In a corner of the room, on the floor.
std::string block_text(const std::string& keys) {
  return "{ 'classname' 'func_wall' " + keys + box_text({16, 16, -64}, {64, 64, -16}, "wall") + "}";
}

TEST(LightLevel, BrushModelsHaveTheirOwnMinimumLight) {
  const LitResult lit =
      light(room_with({block_text("'_minlight' '120' '_minlight_color' '1 0.5 0'"), "'light' '40'"}));
  int of_block = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    // The greater of both, channel by channel.
    const std::array<std::uint8_t, 3> expected =
        luxel.of_world ? std::array<std::uint8_t, 3>{20, 20, 20} : std::array<std::uint8_t, 3>{60, 30, 20};
    ASSERT_EQ(luxel.rgb, expected) << luxel;
    of_block += !luxel.of_world;
  }
  EXPECT_GT(of_block, 0);
}

TEST(LightLevel, FacesThatIgnoreLightKeepTheirMinimum) {
  const LitResult lit = light(room_with(
      {block_text("'_lightignore' '1' '_minlight' '50'") + "{ 'classname' 'light' 'origin' '0 0 0' }"}));
  int of_block = 0;
  for (const RoomLuxel& luxel : room_luxels(lit)) {
    ASSERT_TRUE(luxel.of_world ? luxel.gray > 50 : luxel.gray == 25) << luxel;
    of_block += !luxel.of_world;
  }
  EXPECT_GT(of_block, 0);
}

TEST(LightLevel, BouncedLightReachesFacesThatSeeNoLight) {
  const RoomSetup spot{
      "{ 'classname' 'light' 'origin' '0 0 40' 'light' '300' 'delay' '3' 'mangle' '0 -90 0' 'angle' '60' }",
      ""};
  const LitResult direct = light(room_with(spot));
  const LitResult bounced = light(room_with(spot), {.bounces = 1});
  const LitResult more = light(room_with(spot), {.bounces = 4});
  const auto mean_of_ceiling = [](const LitResult& lit) {
    double sum = 0, count = 0;
    for (const RoomLuxel& luxel : room_luxels(lit))
      if (luxel.normal.z < 0) sum += luxel.gray, ++count;
    return sum / count;
  };
  EXPECT_EQ(mean_of_ceiling(direct), 0);
  EXPECT_GT(mean_of_ceiling(bounced), 5);
  EXPECT_GT(mean_of_ceiling(more), mean_of_ceiling(bounced));
}

TEST(LightLevel, DirtDarkensCorners) {
  const RoomSetup clean{
      "{ 'classname' 'light' 'origin' '0 0 0' 'light' '200' 'delay' '3' '_anglescale' '0' }", ""};
  RoomSetup dirty = clean;
  dirty.world_keys = "'_dirt' '1' '_dirtdepth' '40'";
  const auto before = room_luxels(light(room_with(clean)), 0, 1),
             after = room_luxels(light(room_with(dirty)), 0, 1);
  int corners = 0, middles = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    // The distance to the nearest other wall: the middle one of the three, since the least is the one unit to
    // the luxel's own wall.
    std::array<double, 3> from_walls{};
    for (int axis = 0; axis < 3; ++axis)
      from_walls[static_cast<std::size_t>(axis)] = kHalfRoom - std::abs(before[i].place_world[axis]);
    std::sort(from_walls.begin(), from_walls.end());
    if (from_walls[1] > 42) {
      EXPECT_EQ(after[i].gray, before[i].gray);
      ++middles;
    } else if (from_walls[1] < 20) {
      EXPECT_LT(after[i].gray, before[i].gray - 5);
      ++corners;
    }
  }
  EXPECT_GT(middles, 3);
  EXPECT_GT(corners, 20);
}

// Whether nothing solid but what is behind one plane is within three units: at the foot of a pillar's edge,
// light differs from side to side.
bool is_open_around(const world::Level& level, const math::Vec3d& place) {
  int solid = 0;
  for (const int x : {-3, 3})
    for (const int y : {-3, 3})
      for (const int z : {-3, 3})
        solid +=
            world::point_contents(level, math::Vec3(place + math::Vec3d(x, y, z))) == world::Contents::kSolid;
  return solid == 4;
}

// Luxels of different faces at the same place of one plane, on the edge of both, measure the same light. With
// extra 1, luxels get more rays where their neighbors of the same face have other shadows. At the end of a
// shadow, one of two faces may have such a neighbor, while the other one has none.
TEST(LightLevel, NoStripesBetweenCoplanarFaces) {
  for (const int extra : {1, 2, effort(4, 2)}) {
    const LitResult lit = light(small_level_with_all(), {.extra = extra, .bounces = 0});
    const auto level = world::make_level(lit.bsp, "lit").value();
    std::map<std::tuple<std::uint32_t, bool, std::uint32_t, int, int>, std::vector<int>> at;
    for (const world::Face& face : level->faces) {
      if (face.light == world::kNoLight) continue;
      for (int row = 0; row < face.light_height(); ++row)
        for (int column = 0; column < face.light_width(); ++column) {
          const math::Vec3d place = luxel_place(*level, face, column, row);
          if (glm::length(world::find_nearest_point(*level, face, place) - place) > 0.01) continue;
          if (!is_open_around(*level, place)) continue;
          at[{face.plane, face.back_side, face.axes, face.texture_mins[0] / 16 + column,
              face.texture_mins[1] / 16 + row}]
              .push_back(
                  level->light[face.light + static_cast<std::size_t>(row * face.light_width() + column)]);
        }
    }
    const int most = extra == 1 ? 4 : 2;
    int seams = 0, stripes = 0;
    for (const auto& [place, values] : at) {
      if (values.size() < 2) continue;
      ++seams;
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      if (*high - *low > most) {
        ++stripes;
        ADD_FAILURE() << *low << " beside " << *high << " with extra " << extra;
      }
    }
    EXPECT_GT(seams, 100);
    EXPECT_EQ(stripes, 0) << "of " << seams << " with extra " << extra;
  }
}

}  // namespace
}  // namespace temblor::test
