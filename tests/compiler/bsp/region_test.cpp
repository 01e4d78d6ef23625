// Maps of which only a part is compiled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/drafts.h"
#include "formats/levels/entities.h"
#include "support/levels/room_map.h"
#include "support/random.h"
#include "world/level.h"

namespace temblor::test {
namespace {

using math::Vec3d;
using ::testing::HasSubstr;

// A hall of 512 units; its far half, beyond x 128, is outside the region.
constexpr Vec3d kHallMins(-256, -128, 0), kHallMaxs(256, 128, 128);

std::string hall(const std::string& more_brushes) {
  return entity_text("worldspawn", "", walls_text(kHallMins, kHallMaxs, "wall") + more_brushes) +
         point_text("info_player_start", {-200, 0, 32}) + point_text("light", {-100, 0, 64}) +
         point_text("item_health", {200, 0, 16}) +
         entity_text("func_wall", "", box_text({180, 0, 0}, {200, 20, 20}, "box")) +
         entity_text("func_door", "", box_text({-20, 0, 0}, {20, 20, 20}, "door"));
}

const std::string kNearHalf = box_text({-250, -120, 8}, {0, 120, 120}, "REGION");

std::vector<std::string> classnames(const compiler::DraftResult& result) {
  std::vector<std::string> names;
  const std::vector<formats::Entity> entities = formats::read_entities(result.draft.bsp.entities).value();
  for (const formats::Entity& entity : entities) names.emplace_back(entity.classname());
  return names;
}

std::string list_warnings(const compiler::Warnings& warnings) {
  std::string text;
  for (const compiler::Warning& warning : warnings) text += warning.kind + ": " + warning.what + "\n";
  return text;
}

TEST(Region, MakesASealedLevelOfItsBounds) {
  compiler::Warnings warnings;
  const compiler::DraftResult result =
      try_compile_draft(hall(kNearHalf + box_text({-60, -60, 0}, {60, 60, 64}, "block") +
                             box_text({100, 0, 0}, {120, 20, 64}, "far")),
                        warnings)
          .value();
  EXPECT_FALSE(result.leak);
  EXPECT_EQ(find_level_fault(result), "");
  EXPECT_EQ(contents_at(result, {-200, 0, 32}), world::Contents::kEmpty);
  EXPECT_EQ(contents_at(result, {-30, 0, 32}), world::Contents::kSolid) << "the block";
  EXPECT_EQ(contents_at(result, {30, 100, 32}), world::Contents::kSolid) << "outside of the region";
  EXPECT_DOUBLE_EQ(measure_area(result, "REGION", 0, -1, 0), 240 * 112 - 120 * 56)
      << "the cut face of the hall, without the block's";
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "block", 64), 60 * 120) << "cut in two";
  EXPECT_EQ(count_faces(result, "far"), 0);
  EXPECT_EQ(count_faces(result, "wall"), 0) << "the bounds keep clear of all walls";
  EXPECT_THAT(classnames(result),
              ::testing::ElementsAre("worldspawn", "info_player_start", "light", "func_door"));
  EXPECT_EQ(result.draft.bsp.models.size(), 2u);
  EXPECT_THAT(list_warnings(warnings), HasSubstr("left out: 8 brushes, 2 entities"));
  EXPECT_THAT(list_warnings(warnings), ::testing::Not(HasSubstr("info_player_start")));
}

// contents_at for many points of one level.
world::Contents point_contents(const world::Level& level, const math::Vec3& point) {
  return world::hull_contents(level, world::ModelIndex{0}, world::Hull::kPoint, point);
}

// Wherever the bounds are, everything inside is as in the whole level.
TEST(Region, KeepsContentsOfEveryPointInIt) {
  std::string blocks;
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Vec3d at(random.in_cube(120));
    blocks += box_text(at, at + Vec3d(40, 30, 50), i % 3 == 0 ? "*water" : "block");
  }
  const auto whole = world::make_level(compile_draft(hall(blocks)).draft.bsp, "whole").value();
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random place(seed);
    const Vec3d mins(place.uniform(-250, 0), place.uniform(-120, 0), place.uniform(1, 60));
    const Vec3d maxs = mins + Vec3d(place.uniform(20, 200), place.uniform(20, 120), place.uniform(20, 60));
    const compiler::DraftResult result =
        compile_draft(hall(blocks + box_text(mins, maxs, "region")), {.fill_outside = false});
    const auto part = world::make_level(result.draft.bsp, "part").value();
    for (int i = 0; i < 200; ++i) {
      const math::Vec3 point(mins + (maxs - mins) * (Vec3d(place.in_cube(0.49)) + 0.5));
      EXPECT_EQ(point_contents(*part, point), point_contents(*whole, point)) << seed;
      const math::Vec3 in_the_shell(point.x, point.y, maxs.z + 8);
      EXPECT_EQ(point_contents(*part, in_the_shell), world::Contents::kSolid) << seed;
    }
  }
}

TEST(Region, ShellOfSkyIsSky) {
  const compiler::DraftResult part =
      compile_draft(hall(box_text({40, -100, 8}, {240, 100, 120}, "sky_region")), {.fill_outside = false});
  EXPECT_EQ(contents_at(part, {140, 0, 128}), world::Contents::kSky);
}

TEST(Region, WarnsWithoutAPlayerStart) {
  compiler::Warnings warnings;
  ASSERT_TRUE(try_compile_draft(hall(box_text({40, -100, 8}, {240, 100, 120}, "region")), warnings).ok());
  EXPECT_THAT(list_warnings(warnings), HasSubstr("no info_player_start: the region has none"));
}

TEST(Region, AntiregionLeavesOutWhatItTouches) {
  compiler::Warnings warnings;
  const compiler::DraftResult result =
      try_compile_draft(
          hall(box_text({40, -100, 8}, {240, 100, 120}, "antiregion") +
               box_text({20, 0, 0}, {60, 20, 64}, "inside") + box_text({20, 40, 0}, {40, 60, 64}, "beside")),
          warnings)
          .value();
  EXPECT_FALSE(result.leak);
  EXPECT_EQ(count_faces(result, "inside"), 0);
  EXPECT_GT(count_faces(result, "beside"), 0) << "it only lies against it";
  EXPECT_EQ(count_faces(result, "antiregion"), 0) << "the walls of the hall still close it";
  EXPECT_THAT(classnames(result),
              ::testing::ElementsAre("worldspawn", "info_player_start", "light", "func_door"));
}

TEST(Region, AntiregionThatRemovesAWallLeavesASealedLevel) {
  const compiler::DraftResult result =
      compile_draft(hall(box_text({250, -100, 8}, {300, 100, 120}, "antiregion")));
  EXPECT_FALSE(result.leak);
  EXPECT_GT(count_faces(result, "antiregion"), 0);
}

TEST(Region, OneSideIsNotEnough) {
  std::string brush = box_text({-20, -20, 0}, {20, 20, 20}, "stone");
  brush.replace(brush.find("stone"), 5, "region");
  const compiler::DraftResult result = compile_draft(hall(brush));
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "stone", 20), 40 * 40);
  EXPECT_EQ(contents_at(result, {200, 0, 100}), world::Contents::kEmpty);
}

TEST(Region, ErrorsNameTheBrush) {
  struct Case {
    std::string brushes;
    std::vector<const char*> parts;
  };
  const std::string thin = box_text({0, 0, 0}, {20, 20, 0}, "region");
  for (const Case& c : {Case{kNearHalf + kNearHalf,
                             {"entity 0, brush 7, line 60", "second region", "entity 0, brush 6, line 52"}},
                        Case{thin, {"entity 0, brush 6, line 52", "no volume"}}}) {
    compiler::Warnings warnings;
    const auto result = try_compile_draft(hall(c.brushes), warnings);
    ASSERT_FALSE(result.ok());
    for (const char* part : c.parts) EXPECT_THAT(result.error().message(), HasSubstr(part));
  }
}

}  // namespace
}  // namespace temblor::test
