// Sealed levels, leaks, and pockets (compiler/bsp/outside/fill_outside.h).
#include <gtest/gtest.h>

#include "compiler/drafts.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using compiler::DraftResult;
using math::Vec3d;
using world::Contents;

constexpr double kThick = 16;  // of walls_text()
const std::string kStart = point_text("info_player_start", {0, 0, 32});

// A room with the ceiling made of `ceiling_brushes` above z = 128.
std::string room_under(const std::string& ceiling_brushes) {
  const Vec3d outer_mins = kRoomMins - kThick;
  const Vec3d outer_maxs(kRoomMaxs.x + kThick, kRoomMaxs.y + kThick, kRoomMaxs.z);
  std::string walls = box_text(outer_mins, {outer_maxs.x, outer_maxs.y, 0}, "wall");
  for (int axis = 0; axis < 2; ++axis)
    for (const bool is_upper : {false, true}) {
      Vec3d mins = outer_mins, maxs = outer_maxs;
      (is_upper ? mins : maxs)[axis] = is_upper ? kRoomMaxs[axis] : kRoomMins[axis];
      walls += box_text(mins, maxs, "wall");
    }
  return entity_text("worldspawn", "", walls + ceiling_brushes);
}
const Vec3d kCeilingMins(-144, -144, 128), kCeilingMaxs(144, 144, 144);

TEST(Sealing, DetailThroughSkyOrSolidMakesNoHole) {
  for (const char* ceiling : {"sky1", "wall"})
    for (const char* kind :
         {"func_detail", "func_detail_wall", "func_detail_fence", "func_detail_illusionary"}) {
      const DraftResult result =
          compile_draft(room_under(box_text(kCeilingMins, kCeilingMaxs, ceiling)) +
                        entity_text(kind, "", box_text({-16, -16, 64}, {16, 16, 200}, "pillar")) + kStart);
      EXPECT_FALSE(result.leak) << kind << " through " << ceiling;
      EXPECT_EQ(find_level_fault(result), "");
      EXPECT_EQ(contents_at(result, {0, 0, 190}), Contents::kSolid) << "the outside is filled";
      EXPECT_GT(count_faces(result, "pillar"), 0) << kind;
    }
}

TEST(Sealing, DetailAloneMakesAHole) {
  const std::string ceiling = box_text(kCeilingMins, kCeilingMaxs, "stone");
  for (const char* kind : {"func_detail", "func_detail_wall"})
    EXPECT_TRUE(compile_draft(room_under("") + entity_text(kind, "", ceiling) + kStart).leak) << kind;
}

TEST(Sealing, AnEntityOnAnOuterFaceIsNoLeak) {
  const double top = kRoomMaxs.z + kThick;
  for (const Vec3d& place :
       {Vec3d(0, 0, top), Vec3d(0, 0, -kThick), Vec3d(144, 144, top), Vec3d(144, 0, 64)}) {
    const DraftResult result = compile_draft(room_text() + point_text("light", place));
    EXPECT_FALSE(result.leak) << place.x << " " << place.y << " " << place.z;
    EXPECT_EQ(find_level_fault(result), "");
  }
  EXPECT_TRUE(compile_draft(room_text() + point_text("light", {0, 0, top + 2})).leak);
}

// A light at the end of a thin wall, outside by less than a unit.
TEST(Sealing, AnEntityWithinAUnitOfTheInsideIsNoLeak) {
  const std::string plate = box_text({-144, -144, 128}, {144, 144, 128.5}, "plate");
  EXPECT_FALSE(compile_draft(room_under(plate) + kStart + point_text("light", {0, 0, 128.75})).leak);
  EXPECT_TRUE(compile_draft(room_under(plate) + kStart + point_text("light", {0, 0, 130})).leak);
}

// Items are often placed exactly on the floor: they must not hide a real leak.
TEST(Sealing, EntitiesOnTheFloorOfAnOpenRoomLeak) {
  EXPECT_TRUE(compile_draft(room_under("") + point_text("item_health", {0, 0, 0})).leak);
  EXPECT_TRUE(compile_draft(room_under("") + kStart + point_text("item_health", {0, 0, 0})).leak);
}

TEST(Sealing, SlitsLeakIfTheyAreWiderThanATenth) {
  for (const double width : {0.0, 0.02, 0.05, 0.09, 0.15, 0.175, 0.3, 1.0}) {
    const std::string halves = box_text(kCeilingMins, {-width / 2, 144, 144}, "left") +
                               box_text({width / 2, -144, 128}, kCeilingMaxs, "right");
    const DraftResult result = compile_draft(room_under(halves) + kStart);
    EXPECT_EQ(result.leak.has_value(), width > 0.1) << width;
    EXPECT_EQ(find_level_fault(result), "");
  }
}

// Two sides that differ by a few hundredths of a degree leave a wedge between the brushes.
TEST(Sealing, WedgesBetweenNearlyParallelSidesLeakWhereTheyAreWide) {
  for (const double end : {0.02, 0.09, 0.15, 0.5}) {  // the width of the wedge at y = 144
    const std::string left = box_text(kCeilingMins, {0, 144, 144}, "left");
    // The side at x = 0 is turned around the edge at y = -144.
    std::string right = box_text({0, -144, 128}, kCeilingMaxs, "right");
    const std::string side = "( 0 -144 128 ) ( 0 144 128 ) ( 0 -144 144 )";
    ASSERT_NE(right.find(side), std::string::npos) << right;
    right.replace(right.find(side), side.size(),
                  fmt::format("( 0 -144 128 ) ( {} 144 128 ) ( 0 -144 144 )", end));
    const DraftResult result = compile_draft(room_under(left + right) + kStart);
    EXPECT_EQ(result.leak.has_value(), end > 0.1) << end;
    EXPECT_EQ(find_level_fault(result), "");
  }
}

// Walls that stand on a floor, which reaches far beyond them with `floor_reach_units`.
std::string room_on_floor(double floor_reach_units) {
  const double reach = 144 + floor_reach_units;
  std::string walls = box_text({-144, -144, 128}, {144, 144, 144}, "wall") +
                      box_text({-reach, -reach, -16}, {reach, reach, 0}, "floor");
  for (const double side : {-1.0, 1.0}) {
    walls += box_text(glm::min(Vec3d(128 * side, -144, 0), Vec3d(144 * side, 0, 0)),
                      glm::max(Vec3d(128 * side, 0, 128), Vec3d(144 * side, 144, 128)), "wall");
    walls += box_text(glm::min(Vec3d(-128, 128 * side, 0), Vec3d(0, 144 * side, 0)),
                      glm::max(Vec3d(0, 128 * side, 128), Vec3d(128, 144 * side, 128)), "wall");
  }
  return walls;
}

// A hint whose top goes from z = -`begin` at y = -200 to z = -`end` at y = `far`.
std::string hint_below_floor(double begin, double end, double far) {
  std::string hint = box_text({-200, -200, -8}, {200, far, -1}, "hintskip");
  hint.erase(hint.rfind(fmt::format("( 200 {} -1", far)));
  return hint + fmt::format("( 200 {0} -{2} ) ( 200 -200 -{1} ) ( -200 {0} -{2} ) hint 0 0 0 1 1\n}}\n", far,
                            begin, end);
}

// A hint's side cuts the floor just below its top, and the slice above is too thin for a piece of the floor's
// brush. It passes below the walls.
TEST(Sealing, SlicesOfABrushDoNotLeak) {
  for (const double depth : {0.02, 0.04, 0.06, 0.08}) {
    const std::string world = room_on_floor(112) + hint_below_floor(depth + 0.01, depth, 200);
    const DraftResult result = compile_draft(entity_text("worldspawn", "", world) + kStart);
    EXPECT_FALSE(result.leak) << depth;
    EXPECT_EQ(find_level_fault(result), "");
  }
}

// The floor ends behind the walls. Beyond its end, the slice gets wider.
TEST(Sealing, SlicesThatGetWiderOutsideDoNotLeak) {
  for (const double end : {0.05, 0.15, 0.3}) {
    const std::string world = room_on_floor(0) + hint_below_floor(0.02, end, 1000);
    const DraftResult result = compile_draft(entity_text("worldspawn", "", world) + kStart);
    EXPECT_FALSE(result.leak) << end;
    EXPECT_EQ(find_level_fault(result), "");
  }
}

// A hole is a hole, however thinly hints slice it.
TEST(Sealing, SlicesOfAHoleLeak) {
  std::string slices;
  for (const double height : {90.0, 90.05, 90.09})
    slices += box_text({-144, -144, height - 60}, {144, 144, height}, "hint");
  EXPECT_TRUE(compile_draft(room_under(slices) + kStart).leak);
}

TEST(Sealing, PocketsWithoutEntitiesAreFilled) {
  const Vec3d mins(512, 0, 0), maxs(576, 64, 64), middle(544, 32, 32);
  const std::string world = entity_text(
      "worldspawn", "", walls_text(kRoomMins, kRoomMaxs, "wall") + walls_text(mins, maxs, "pocket"));
  const DraftResult bare = compile_draft(world + kStart);
  EXPECT_EQ(contents_at(bare, math::Vec3(middle)), Contents::kSolid);
  EXPECT_EQ(count_faces(bare, "pocket"), 0);
  EXPECT_EQ(count_faces(bare, "wall"), count_faces(compile_draft(room_text()), "wall"));
  for (const std::string& inhabitant :
       {point_text("info_teleport_destination", middle),
        entity_text("func_wall", "", box_text(middle - 8.0, middle + 8.0, "block"))}) {
    const DraftResult kept = compile_draft(world + kStart + inhabitant);
    EXPECT_EQ(contents_at(kept, math::Vec3(middle + 16.0)), Contents::kEmpty) << inhabitant;
    EXPECT_EQ(count_faces(kept, "pocket"), 6) << inhabitant;
  }
}

}  // namespace
}  // namespace temblor::test
