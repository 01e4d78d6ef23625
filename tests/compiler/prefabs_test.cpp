#include "compiler/prefabs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace temblor::compiler {
namespace {

using math::Vec3d;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

// A world with one brush with one side, which faces x at `distance`.
std::string one_side(const std::string& distance, const std::string& more_entities = "") {
  return "{\n\"classname\" \"worldspawn\"\n{\n( " + distance + " 0 0 ) ( " + distance + " 1 0 ) ( " +
         distance + " 0 1 ) wall 0 0 0 1 1\n}\n}\n" + more_entities;
}

std::string prefab(const std::string& file, const std::string& pairs = "") {
  return "{\n\"classname\" \"misc_external_map\"\n\"_external_map\" \"" + file + "\"\n" + pairs + "}\n";
}

struct Expanded {
  base::Result<formats::Map> map;
  Warnings warnings;

  std::string error() const { return map.ok() ? "no error" : map.error().message(); }
};

using MapFiles = std::map<fs::path, std::string>;

Expanded expand(const std::string& text, const MapFiles& files) {
  const auto read_text = [&](const fs::path& path) -> base::Result<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return base::error(base::ErrorCode::kNotFound, "no such file");
    return found->second;
  };
  Warnings warnings;
  auto map = expand_prefabs(formats::read_map(text).value(), "maps/level.map", read_text, warnings);
  return {std::move(map), std::move(warnings)};
}

// The points of the only side of the only brush of the first entity.
std::array<Vec3d, 3> parse_points(const std::string& pairs) {
  const Expanded expanded = expand(prefab("p.map", pairs), {{"maps/p.map", one_side("8")}});
  EXPECT_EQ(expanded.error(), "no error");
  return expanded.map->entities.at(0).brushes.at(0).sides.at(0).points_world;
}

TEST(Prefabs, LeavesMapsWithoutPrefabsUnchanged) {
  const std::string text = one_side("1", "{\n\"classname\" \"light\"\n}\n");
  const Expanded expanded = expand(text, {});
  EXPECT_EQ(*expanded.map, formats::read_map(text).value());
  EXPECT_THAT(expanded.warnings, IsEmpty());
}

TEST(Prefabs, BrushesReplaceTheEntityAndTakeItsLine) {
  const Expanded expanded =
      expand(one_side("1") + prefab("../parts/lamp.map", "\"origin\" \"16 0 4\"\n\"_phong\" \"1\"\n"),
             {{"parts/lamp.map", one_side("8",
                                          "{\n\"classname\" \"func_group\"\n{\n}\n}\n{\n\"classname\" "
                                          "\"func_detail_wall\"\n{\n}\n}\n")}});
  ASSERT_EQ(expanded.error(), "no error");
  EXPECT_THAT(expanded.warnings, IsEmpty());
  ASSERT_EQ(expanded.map->entities.size(), 2u);
  const formats::MapEntity& lamp = expanded.map->entities[1];
  EXPECT_THAT(lamp.fields.pairs, ElementsAre(std::pair<std::string, std::string>("classname", "func_detail"),
                                             std::pair<std::string, std::string>("_phong", "1")));
  ASSERT_EQ(lamp.brushes.size(), 3u);
  EXPECT_EQ(lamp.brushes[0].line, 7u);
  EXPECT_EQ(lamp.brushes[0].sides[0].line, 7u);
  EXPECT_EQ(lamp.brushes[0].sides[0].points_world,
            (std::array{Vec3d(24, 0, 4), Vec3d(24, 1, 4), Vec3d(24, 0, 5)}));
}

TEST(Prefabs, ClassCanBeChosen) {
  const auto classname = [](const std::string& pairs) {
    const Expanded expanded = expand(prefab("p.map", pairs), {{"maps/p.map", one_side("8")}});
    return std::string(expanded.map->entities.at(0).fields.classname());
  };
  EXPECT_EQ(classname(""), "func_detail");
  EXPECT_EQ(classname("\"_external_map_classname\" \"func_wall\"\n"), "func_wall");
  EXPECT_EQ(classname("\"_classname\" \"func_wall\"\n"), "func_wall");
  EXPECT_EQ(classname("\"_external_map_classname\" \"worldspawn\"\n"), "func_group");
}

TEST(Prefabs, AreScaledThenTurnedThenMoved) {
  using Points = std::array<Vec3d, 3>;
  EXPECT_EQ(parse_points("\"_external_map_scale\" \"2\"\n"),
            (Points{Vec3d(16, 0, 0), Vec3d(16, 2, 0), Vec3d(16, 0, 2)}));
  EXPECT_EQ(parse_points("\"_scale\" \"1 3 4\"\n"), (Points{Vec3d(8, 0, 0), Vec3d(8, 3, 0), Vec3d(8, 0, 4)}));
  // Yaw turns x to y; on the grid it is exact.
  EXPECT_EQ(parse_points("\"_external_map_angle\" \"90\"\n"),
            (Points{Vec3d(0, 8, 0), Vec3d(-1, 8, 0), Vec3d(0, 8, 1)}));
  EXPECT_EQ(parse_points("\"_external_map_angles\" \"0 90 0\"\n\"_scale\" \"2\"\n\"origin\" \"1 2 3\"\n"),
            (Points{Vec3d(1, 18, 3), Vec3d(-1, 18, 3), Vec3d(1, 18, 5)}));
  // A negative pitch is down.
  EXPECT_EQ(parse_points("\"_external_map_angles\" \"-90 0 0\"\n")[0], Vec3d(0, 0, -8));
  // In a mirrored brush the points run the other way round, so that it is not inside out.
  EXPECT_EQ(parse_points("\"_scale\" \"-1 1 1\"\n"),
            (Points{Vec3d(-8, 0, 1), Vec3d(-8, 1, 0), Vec3d(-8, 0, 0)}));
}

TEST(Prefabs, NestedPathsAreRelativeToTheirFile) {
  const Expanded expanded =
      expand(prefab("a\\a.map", "\"origin\" \"0 0 100\"\n\"_angle\" \"90\"\n"),
             {{"maps/a/a.map", one_side("1") + prefab("b.map", "\"origin\" \"10 0 0\"\n")},
              {"maps/a/b.map", one_side("2")}});
  ASSERT_EQ(expanded.error(), "no error");
  const auto& brushes = expanded.map->entities.at(0).brushes;
  ASSERT_EQ(brushes.size(), 2u);
  EXPECT_EQ(brushes[0].sides[0].points_world[0], Vec3d(0, 1, 100));
  EXPECT_EQ(brushes[1].sides[0].points_world[0], Vec3d(0, 12, 100));
}

TEST(Prefabs, WarnAboutOtherEntitiesOncePerFile) {
  const Expanded expanded = expand(prefab("p.map") + prefab("p.map"),
                                   {{"maps/p.map", one_side("1", "{\n\"classname\" \"light\"\n}\n")}});
  ASSERT_EQ(expanded.warnings.size(), 1u);
  EXPECT_EQ(
      expanded.warnings[0].what,
      "maps/p.map: 1 of 2 entities; only worldspawn, func_group, func_detail and misc_external_map are used");
}

TEST(Prefabs, VisBlockersKeepTheirClass) {
  const auto blocker = [](const std::string& distance) {
    std::string text = one_side(distance);
    return text.replace(text.find("worldspawn"), 10, "func_illusionary_visblocker");
  };
  const MapFiles files{{"maps/p.map", one_side("8", blocker("16") + prefab("q.map"))},
                       {"maps/q.map", one_side("32", blocker("64"))}};
  const Expanded expanded = expand(
      one_side("1") + prefab("p.map", "\"origin\" \"100 0 0\"\n\"_external_map_classname\" \"func_wall\"\n") +
          "{\n\"classname\" \"light\"\n}\n",
      files);
  ASSERT_EQ(expanded.error(), "no error");
  EXPECT_THAT(expanded.warnings, IsEmpty());
  std::vector<std::string> seen;
  for (const formats::MapEntity& entity : expanded.map->entities) {
    seen.emplace_back(entity.fields.classname());
    for (const formats::MapBrush& brush : entity.brushes)
      seen.push_back(fmt::format("{}", brush.sides.at(0).points_world[0].x));
  }
  EXPECT_THAT(seen, ElementsAre("worldspawn", "1", "func_wall", "108", "132", "light",
                                "func_illusionary_visblocker", "116", "164"));
  EXPECT_EQ(expanded.map->entities.back().line, expanded.map->entities[1].line);
}

TEST(Prefabs, ErrorsNameTheEntityAndTheFile) {
  const auto error = [](const std::string& pairs) {
    return expand(one_side("1") + prefab("p.map", pairs), {{"maps/p.map", one_side("8")}}).error();
  };
  const std::string place = "entity 1 (misc_external_map), line 7: ";
  EXPECT_EQ(error("\"_scale\" \"0\"\n"), place + "_scale must be one number or three, and none may be 0");
  EXPECT_EQ(error("\"_scale\" \"1 2\"\n"), place + "_scale must be one number or three, and none may be 0");
  EXPECT_EQ(error("\"_external_map_angles\" \"90\"\n"),
            place + "_external_map_angles must be three numbers: pitch yaw roll");
  EXPECT_EQ(error("\"_angle\" \"up\"\n"), place + "_angle must be one number, the yaw");
  EXPECT_EQ(error("\"origin\" \"nan 0 0\"\n"), place + "origin must be three numbers");
  EXPECT_EQ(
      error("\"_scale\" \"1e30\"\n"),
      place + "the brush on line 3 of maps/p.map would be beyond +-16777216 units: move or scale the prefab");
  EXPECT_EQ(expand("{\n\"classname\" \"misc_external_map\"\n}\n", {}).error(),
            "entity 0 (misc_external_map), line 1: set _external_map to the file of the prefab");
  EXPECT_EQ(expand(prefab("q.map"), {}).error(),
            "entity 0 (misc_external_map), line 1: prefab maps/q.map: no such file");
  EXPECT_EQ(expand(prefab("p.map"), {{"maps/p.map", "{\n{\n"}}).error(),
            "maps/p.map: entity 0, brush 0, line 2: this brush is never closed");
  EXPECT_EQ(expand(prefab("p.map"), {{"maps/p.map", one_side("1") + prefab("q.map")}}).error(),
            "maps/p.map: entity 1 (misc_external_map), line 7: prefab maps/q.map: no such file");
}

TEST(Prefabs, OmitBrushesOnRequest) {
  std::string guide = one_side("2");
  guide.replace(guide.find("worldspawn"), 10, "func_group\"\n\"_omitbrushes\" \"1");
  const Expanded expanded =
      expand(one_side("1", guide + prefab("p.map")), {{"maps/p.map", one_side("8", guide)}});
  EXPECT_EQ(expanded.error(), "no error");
  std::vector<std::size_t> brushes;
  for (const formats::MapEntity& entity : expanded.map->entities) brushes.push_back(entity.brushes.size());
  EXPECT_THAT(brushes, ElementsAre(1, 0, 1));
}

TEST(Prefabs, RejectCyclesAndNameTheChain) {
  EXPECT_EQ(
      expand(prefab("a.map"), {{"maps/a.map", prefab("b.map")}, {"maps/b.map", prefab("./x/../a.map")}})
          .error(),
      "maps/b.map: entity 0 (misc_external_map), line 1: the maps include each other: maps/level.map -> "
      "maps/a.map -> maps/b.map -> maps/a.map");
  EXPECT_THAT(expand(prefab("level.map"), {}).error(),
              HasSubstr("each other: maps/level.map -> maps/level.map"));
}

TEST(Prefabs, RejectTooManyOrTooDeep) {
  MapFiles deep;
  for (int i = 0; i < 20; ++i)
    deep["maps/" + std::to_string(i) + ".map"] = prefab(std::to_string(i + 1) + ".map");
  EXPECT_THAT(expand(prefab("0.map"), deep).error(), HasSubstr("at most 16 deep"));
  // Each names the next one ten times: 10^9 in all, if nothing counted them.
  MapFiles many;
  for (int i = 0; i < 9; ++i)
    for (int copies = 0; copies < 10; ++copies)
      many["maps/" + std::to_string(i) + ".map"] += prefab(std::to_string(i + 1) + ".map");
  many["maps/9.map"] = one_side("1");
  EXPECT_THAT(expand(prefab("0.map"), many).error(), HasSubstr("at most 65536 prefabs"));
}

}  // namespace
}  // namespace temblor::compiler
