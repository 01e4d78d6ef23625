// Keys of brush entities that control light, in rooms where the result is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "compiler/light/lighting.h"
#include "compiler/light/lit_map.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using math::Vec3d;

constexpr Vec3d kUp(0, 0, 1);

// A room, 256 units high, with a lamp below its ceiling and other brushes in it.
std::string room_text(std::string_view entities, std::string_view world_keys = "") {
  return entity_text("worldspawn", world_keys, walls_text({-128, -128, 0}, {128, 128, 256}, "stone")) +
         point_text("info_player_start", {-100, -100, 40}) +
         entity_text("light", "\"origin\" \"0 0 240\"\n\"light\" \"400\"") + std::string(entities);
}

double light_on(const world::Level& level, const Vec3d& place) {
  return shown_light(level, face_under(level, place, kUp), place).x;
}

// Two plates of one entity, the lower plate and the center of the floor in the shadow of the upper one.
// Between them and the floor is a plate of another entity.
struct Shadows {
  bool on_itself = false, on_others = false, on_world = false;
  bool operator==(const Shadows&) const = default;
};
Shadows shadows_with(std::string_view keys) {
  const std::string text =
      room_text(entity_text("func_wall", keys,
                            box_text({-24, -24, 160}, {24, 24, 168}, "wood") +
                                box_text({-24, -24, 120}, {24, 24, 128}, "wood")) +
                entity_text("func_wall", "", box_text({-40, -40, 60}, {40, 40, 68}, "steel")));
  const auto level = lit_map(text);
  const auto is_dark = [&](const Vec3d& place) {
    const double light = light_on(*level, place);
    EXPECT_TRUE(light == 0 || light > 20) << light << " at " << place.z << " with " << keys;
    return light == 0;
  };
  EXPECT_FALSE(is_dark({0, 0, 168})) << keys;
  EXPECT_FALSE(is_dark({-120, 120, 0})) << keys;
  return {is_dark({0, 0, 128}), is_dark({0, 0, 68}), is_dark({0, 0, 0})};
}

TEST(LightKeys, ShadowsFallOnTheChosenReceivers) {
  EXPECT_EQ(shadows_with(""), (Shadows{false, false, false}));
  EXPECT_EQ(shadows_with("\"_shadow\" \"1\""), (Shadows{true, true, true}));
  EXPECT_EQ(shadows_with("\"_shadowself\" \"1\""), (Shadows{true, false, false}));
  EXPECT_EQ(shadows_with("\"_shadowworldonly\" \"1\""), (Shadows{false, false, true}));
  // The more general key wins.
  EXPECT_EQ(shadows_with("\"_shadow\" \"1\"\n\"_shadowself\" \"1\""), (Shadows{true, true, true}));
}

TEST(LightKeys, OpaqueGlassTintsMore) {
  formats::Palette red{};
  red.fill({255, 51, 0});
  const auto floor_light = [&](const std::string& keys) {
    const auto level = lit_map(
        room_text(entity_text("func_wall", keys, box_text({-128, -128, 160}, {128, 128, 168}, "glass"))),
        {{}, red});
    return shown_light(*level, face_under(*level, {0, 0, 0}, kUp), {0, 0, 0});
  };
  const Vec3d open = floor_light("");
  EXPECT_GT(open.x, 60);
  EXPECT_EQ(open.y, open.x);
  for (const double alpha : {0.25, 0.5, 0.75}) {
    const Vec3d behind = floor_light(fmt::format("\"_shadow\" \"1\"\n\"alpha\" \"{}\"", alpha));
    EXPECT_NEAR(behind.x, open.x, 1) << alpha;
    EXPECT_NEAR(behind.y, open.x * (1 - alpha * 0.8), 1) << alpha;
    EXPECT_NEAR(behind.z, open.x * (1 - alpha), 1) << alpha;
  }
  EXPECT_EQ(floor_light("\"_shadow\" \"1\"\n\"alpha\" \"1\""), Vec3d(0.0));
}

// A block that is half inside the floor of a dark corner: the buried part of its side is hidden, but shows
// when the block rises.
TEST(LightKeys, AutoMinLightIsTheLightAtTheCenter) {
  const auto side_light = [](const char* value, double z) {
    const auto level =
        lit_map(room_text(entity_text("func_wall", fmt::format("\"_autominlight\" \"{}\"", value),
                                      box_text({64, -24, -200}, {96, 24, 56}, "wood"))));
    const Vec3d place(64, 0, z);
    return shown_light(*level, face_under(*level, place, {-1, 0, 0}), place).x;
  };
  // In the open, nothing changes.
  const double open = side_light("0", 40);
  EXPECT_GT(open, 20);
  EXPECT_EQ(side_light("1", 40), open);
  EXPECT_EQ(side_light("-1", 40), open);
  // Deep below the floor: with 1 the center counts, which is inside the floor too, and dark.
  EXPECT_GT(side_light("0", -150), 20);
  EXPECT_EQ(side_light("1", -150), 0);
}

TEST(LightKeys, AutoMinLightOfHiddenFacesCanBeTurnedOff) {
  const auto level_with = [](const char* value) {
    return lit_map(room_text(entity_text(
        "func_door", fmt::format("\"_autominlight\" \"{}\"\n\"origin\" \"0 0 0\"", value),
        box_text({-32, -32, -16}, {32, 32, 256}, "wood") + box_text({120, -8, 100}, {140, 8, 116}, "wood"))));
  };
  const Vec3d hidden(140, 0, 108);
  const auto taken = level_with("0"), off = level_with("-1");
  EXPECT_GT(shown_light(*taken, face_under(*taken, hidden, {1, 0, 0}), hidden).x, 0);
  EXPECT_EQ(shown_light(*off, face_under(*off, hidden, {1, 0, 0}), hidden).x, 0);
}

TEST(LightKeys, OtherStylesBounceOnRequest) {
  const auto spot = [](const char* style, const char* keys) {
    return light(
        room_with({std::string("{ 'classname' 'light' 'origin' '0 0 40' 'light' '300' 'delay' '3' 'mangle' "
                               "'0 -90 0' 'angle' '60' 'style' '") +
                       style + "' }",
                   keys}));
  };
  const auto plain = room_luxels(spot("0", "'_bounce' '2'"));
  const auto unstyled = room_luxels(spot("3", "'_bounce' '2'"), 3);
  const auto styled = room_luxels(spot("3", "'_bounce' '2' '_bouncestyled' '1'"), 3);
  ASSERT_EQ(plain.size(), styled.size());
  int bounced = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(styled[i].gray, plain[i].gray);
    if (plain[i].normal.z > -0.5) continue;  // the ceiling, which the spotlight does not reach
    EXPECT_EQ(unstyled[i].gray, 0);
    bounced += plain[i].gray > 5 ? 1 : 0;
  }
  EXPECT_GT(bounced, 10);
}

// Checks bytes, since our own reader does not use the light of liquids.
TEST(LightKeys, LiquidsHaveLightMapsUnlessAKeySaysNo) {
  const auto brightest_water = [](const std::string& world_keys, const std::string& group_keys) {
    const LitResult lit = light(room_with(
        {"{ 'classname' 'light' 'origin' '0 0 50' }" +
             entity_text("func_group", group_keys, box_text({-64, -64, -64}, {64, 64, 0}, "*water")),
         world_keys}));
    int brightest = 0;
    for (const formats::BspFace& face : lit.bsp.faces) {
      const formats::BspTexinfo& texinfo = lit.bsp.texinfos[face.texinfo];
      const std::string& name = lit.bsp.miptexes[static_cast<std::size_t>(texinfo.miptex)].name;
      if (name != "*water" || face.light_offset < 0) continue;
      EXPECT_EQ(texinfo.flags, 0);
      brightest = std::max<int>(brightest, lit.bsp.lighting[static_cast<std::size_t>(face.light_offset)]);
    }
    return brightest;
  };
  const std::string yes = "'_litwater' '1'", no = "'_litwater' '0'";
  EXPECT_GT(brightest_water("", ""), 0);
  EXPECT_EQ(brightest_water(no, ""), 0);
  EXPECT_EQ(brightest_water(yes, no), 0);
  EXPECT_GT(brightest_water(no, yes), 0);
  EXPECT_EQ(brightest_water("'_splitturb' '0'", ""), 0) << "another name of _litwater";
  EXPECT_EQ(brightest_water("", "'_splitturb' '0'"), 0);
}

}  // namespace
}  // namespace temblor::test
