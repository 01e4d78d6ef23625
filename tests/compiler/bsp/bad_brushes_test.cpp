// Wrong brushes and maps: they are reported with their place and left out, and the rest of the level is
// compiled.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/drafts.h"
#include "support/effort.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3d;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string all_of(const compiler::Warnings& warnings) {
  std::string text;
  for (const compiler::Warning& warning : warnings) text += warning.kind + ": " + warning.what + "\n";
  return text;
}

std::string side_text(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                      std::string_view rest = "bad 0 0 0 1 1") {
  return fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) {}\n", a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y,
                     c.z, rest);
}

// The sides of a box: its lines without the braces.
std::vector<std::string> list_sides(const Vec3d& mins, const Vec3d& maxs) {
  const std::string text = box_text(mins, maxs, "bad");
  std::vector<std::string> sides;
  for (std::size_t at = text.find('('); at != std::string::npos;) {
    const std::size_t end = text.find('\n', at) + 1;
    sides.push_back(text.substr(at, end - at));
    at = text[end] == '(' ? end : std::string::npos;
  }
  return sides;
}

std::string write_brush_text(const std::vector<std::string>& sides) {
  std::string text = "{\n";
  for (const std::string& side : sides) text += side;
  return text + "}\n";
}

std::string inside_out(const Vec3d& mins, const Vec3d& maxs) {
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  return write_brush_text({side_text(mins + y, mins, mins + z), side_text(mins + z, mins, mins + x),
                           side_text(mins + x, mins, mins + y), side_text(maxs - z, maxs, maxs - y),
                           side_text(maxs - x, maxs, maxs - z), side_text(maxs - y, maxs, maxs - x)});
}

TEST(BadBrushes, AreLeftOutAndReported) {
  const Vec3d mins(-16, -16, 16), maxs(16, 16, 48);
  std::vector<std::string> open = list_sides(mins, maxs);
  open.pop_back();
  std::vector<std::string> wedged = list_sides(mins, maxs);
  wedged.push_back(side_text({0, 0, -100}, {0, 10, -100}, {10, 0, -100}));  // the whole box is in front of it
  const Vec3d far(1e7), step(64);
  struct Case {
    const char* what;
    std::string brush;
  };
  for (const Case& c :
       {Case{"open", write_brush_text(open)}, Case{"of no sides", "{\n}\n"},
        Case{"inside out", inside_out(mins, maxs)}, Case{"flat", box_text({0, 0, 0}, {9, 9, 0}, "bad")},
        Case{"a millionth", box_text(mins, mins + 1e-6, "bad")},
        Case{"a hundredth", box_text(mins, mins + 0.01, "bad")},
        Case{"far", box_text(far, far + step, "bad")},
        Case{"far on one axis", box_text({0, 0, 2e6}, {64, 64, 2e6 + 64}, "bad")},
        Case{"without an inside", write_brush_text(wedged)}}) {
    compiler::Warnings warnings;
    const auto result = try_compile_draft(room_text(c.brush), warnings);
    ASSERT_TRUE(result.ok()) << c.what;
    EXPECT_THAT(all_of(warnings), HasSubstr("brush without volume")) << c.what;
    EXPECT_THAT(all_of(warnings), HasSubstr("entity 0, brush 6, line 52")) << c.what;
    EXPECT_EQ(count_faces(*result, "bad"), 0) << c.what;
    EXPECT_TRUE(result->draft.bsp.leaves.size() == 2 && !result->leak) << c.what;
  }
}

TEST(BadBrushes, SpareSidesChangeNothing) {
  const Vec3d mins(-16, -16, 16), maxs(16, 16, 48);
  const auto good = compile_draft(room_text(box_text(mins, maxs, "bad")));
  std::vector<std::string> twice = list_sides(mins, maxs), degenerate = twice, idle = twice;
  twice.insert(twice.begin() + 2, twice[1]);
  degenerate.insert(degenerate.begin(), side_text({1, 2, 3}, {2, 3, 4}, {3, 4, 5}));
  idle.insert(idle.begin(), side_text({0, 0, 99}, {0, 10, 99}, {10, 0, 99}));
  struct Case {
    const std::vector<std::string>& sides;
    const char* warning;
  };
  for (const Case& c :
       {Case{twice, "duplicate side, ignored: entity 0, brush 6, line 52, side 2"},
        Case{degenerate, "side without area, ignored: entity 0, brush 6, line 52, side 0"}, Case{idle, ""}}) {
    compiler::Warnings warnings;
    const auto result = try_compile_draft(room_text(write_brush_text(c.sides)), warnings);
    ASSERT_TRUE(result.ok());
    EXPECT_THAT(all_of(warnings), HasSubstr(c.warning));
    EXPECT_EQ(result->draft.bsp.faces.size(), good.draft.bsp.faces.size());
    EXPECT_DOUBLE_EQ(measure_area_looking_up(*result, "bad", 48), 32 * 32);
  }
}

TEST(BadBrushes, TextureTooSmallForItsSideIsStretched) {
  const std::string brush = write_brush_text(
      {side_text({-99, 0, 20}, {-99, 1, 20}, {-98, 0, 20}, "fine 0 0 0 0.001 1"),
       side_text({-99, 0, 10}, {-98, 0, 10}, {-99, 1, 10}), side_text({-99, 0, 0}, {-99, 1, 0}, {-99, 0, 1}),
       side_text({99, 0, 0}, {99, 0, 1}, {99, 1, 0}), side_text({0, -99, 0}, {0, -99, 1}, {1, -99, 0}),
       side_text({0, 99, 0}, {1, 99, 0}, {0, 99, 1})});
  compiler::Warnings warnings;
  const auto result = try_compile_draft(room_text(brush), warnings);
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(all_of(warnings),
              HasSubstr("too small for its side, stretched: entity 0, brush 6, line 52, side on line 53"));
  EXPECT_NEAR(measure_area_looking_up(*result, "fine", 20), 198 * 198, 1e-3);
  EXPECT_LT(count_faces(*result, "fine"), 140) << "of 825 that it asks for";
  EXPECT_EQ(find_level_fault(*result), "");
}

// The styles of Quake, of its tools for colors, and of Half-Life.
TEST(BadMaps, AllWaysToWriteALightAreRead) {
  for (const char* value : {"300", "255 128 64", "255 128 64 250"})
    for (const char* key : {"light", "_light"}) {
      compiler::Warnings warnings;
      const std::string light =
          entity_text("light", fmt::format("\"origin\" \"0 0 64\"\n\"{}\" \"{}\"", key, value));
      ASSERT_TRUE(try_compile_draft(room_text() + light, warnings).ok());
      EXPECT_EQ(all_of(warnings), "") << key << " " << value;
    }
}

TEST(BadMaps, AreReportedAndStillMakeALevel) {
  struct Case {
    std::string text;
    const char* warning;
  };
  const std::string start = point_text("info_player_start", {0, 0, 32});
  for (const Case& c :
       {Case{entity_text("worldspawn", "", walls_text(kRoomMins, kRoomMaxs, "wall")), "no info_player_start"},
        Case{room_text() + entity_text("worldspawn", "", box_text({0, 0, 0}, {9, 9, 9}, "bad")),
             "more than one worldspawn: entity 2, line 57"},
        Case{
            entity_text("worldspawn", "\"fog\" \"0.02 60 66 74\"", walls_text(kRoomMins, kRoomMaxs, "wall")) +
                start,
            "fog brighter than white: line 1: fog takes its density, then red, green and blue from 0 to 1"},
        Case{entity_text("worldspawn", "\"_fog\" \"a b c d\"", walls_text(kRoomMins, kRoomMaxs, "wall")) +
                 start,
             "value that cannot be read: entity 0 (worldspawn), line 1: _fog is \"a b c d\" but should be "
             "its "
             "density, or density, red, green and blue; it is ignored"},
        Case{room_text() + entity_text("light", "\"origin\" \"0 0 64\"\n\"light\" \"300 lots\""),
             "value that cannot be read: entity 2 (light), line 57: light is \"300 lots\" but should be a "
             "number, or red, green, blue and a number"},
        Case{room_text() + entity_text("light", "\"origin\" \"0 0\""),
             "origin is \"0 0\" but should be three"},
        Case{room_text() +
                 entity_text("func_wall", "\"_phong\" \"yes\"", box_text({0, 0, 0}, {8, 8, 8}, "bad")),
             "_phong is \"yes\" but should be a number"},
        Case{room_text() + entity_text("func_wall", "\"_object_channel_mask\" \"red\"",
                                       box_text({0, 0, 0}, {8, 8, 8}, "bad")),
             "_object_channel_mask is \"red\" but should be a number"},
        Case{room_text() + entity_text("light", "\"origin\" \"0 0 64\"\n\"_project_mangle\" \"90\""),
             "_project_mangle is \"90\" but should be three"},
        Case{entity_text("worldspawn", "", walls_text(kRoomMins, kRoomMaxs, "skip")) + start,
             "no visible faces"},
        Case{entity_text("worldspawn", "", box_text(Vec3d(-5e5), Vec3d(5e5), "bad")) + start,
             "no visible faces"},
        Case{room_text() + entity_text("func_wall", "", box_text({0, 0, 0}, {8, 8, 8}, "origin")),
             "brush entity without brushes: entity 2 (func_wall), line 57"}}) {
    compiler::Warnings warnings;
    const auto result = try_compile_draft(c.text, warnings);
    ASSERT_TRUE(result.ok()) << c.warning;
    EXPECT_THAT(all_of(warnings), HasSubstr(c.warning));
    EXPECT_EQ(find_level_fault(*result), "") << c.warning;
  }
}

TEST(BadMaps, ReadableAndForeignValuesAreNotReported) {
  compiler::Warnings warnings;
  const auto result = try_compile_draft(
      entity_text("worldspawn", "\"fog\" \"0.02 0.1 0.2 +1\"\n\"_sun_mangle\" \"\"\n\"_sunlight\" \" 250 \"",
                  walls_text(kRoomMins, kRoomMaxs, "wall")) +
          entity_text("info_player_start",
                      "\"origin\" \"0 0 3.2e1\"\n\"light\" \"of my life\"\n\"fog\" \"a b\""),
      warnings);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(all_of(warnings), "");
}

TEST(BadMaps, LongNamesAreCutOnlyInMessages) {
  const std::string name(500, 'n');
  compiler::Warnings warnings;
  const auto result =
      try_compile_draft(room_text(box_text({0, 0, 0}, {9, 9, 9}, name)) +
                            entity_text(name, "", box_text({0, 0, 0}, {8, 8, 0}, name)) +
                            entity_text(name, fmt::format("\"{0}\" \"{0}\"\n\"origin\" \"0 0 999\"", name)),
                        warnings);
  ASSERT_TRUE(result.ok());
  ASSERT_TRUE(result->leak);
  EXPECT_LT(result->leak->classname.size(), 50u);
  for (const compiler::Warning& warning : warnings) EXPECT_LT(warning.what.size(), 100u) << warning.what;
  EXPECT_THAT(result->draft.bsp.entities, HasSubstr(fmt::format("\"{0}\" \"{0}\"", name)));
}

// Planes through any three points, at all scales, in brushes with any number of sides and of any kind.
TEST(BadMaps, AnyPlanesMakeAReadableLevel) {
  constexpr const char* kTextures[] = {"stone", "*water", "sky", "{fence", "hint", "clip", "skip", "*lava"};
  constexpr const char* kClasses[] = {"func_group",
                                      "func_detail",
                                      "func_detail_wall",
                                      "func_detail_fence",
                                      "func_detail_illusionary",
                                      "func_illusionary_visblocker",
                                      "func_wall"};
  int with_volume = 0;
  const int seeds = effort(300, 20);
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::string text = room_text();
    for (int entity = 0; entity < 6; ++entity) {
      std::string brushes;
      for (int i = 0; i < 3; ++i) {
        const double size = random.log_uniform(0.01, 300);
        const Vec3d at(random.in_cube(120));
        std::vector<std::string> sides;
        if (random.chance(0.6)) sides = list_sides(at, at + size);
        for (std::size_t cuts = random.below(8); cuts > 0; --cuts) {
          const auto point = [&] { return at + Vec3d(random.in_cube(size)); };
          sides.push_back(
              side_text(point(), point(), point(),
                        std::string(kTextures[random.below(std::size(kTextures))]) + " 0 0 0 1 1"));
        }
        brushes += write_brush_text(sides);
      }
      const char* const keys[] = {"", "\"_mirrorinside\" \"1\"", "\"_noclipfaces\" \"1\"",
                                  "\"_hulls\" \"5\""};
      text += entity_text(kClasses[random.below(std::size(kClasses))], keys[random.below(4)], brushes);
    }
    compiler::Warnings warnings;
    const auto result = try_compile_draft(text, warnings);
    ASSERT_TRUE(result.ok()) << seed << ": " << result.error().message();
    ASSERT_EQ(find_level_fault(*result), "") << seed;
    with_volume += result->draft.bsp.faces.size() > 20 ? 1 : 0;
  }
  EXPECT_GT(with_volume, seeds / 2);
}

}  // namespace
}  // namespace temblor::test
