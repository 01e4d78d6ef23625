#include "compiler/bsp/make_draft.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/drafts.h"
#include "formats/levels/entities.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using compiler::DraftResult;
using math::Vec3d;

TEST(MakeDraft, RoomIsOneLeafAndSixFaces) {
  const DraftResult result = compile_draft(room_text());
  EXPECT_FALSE(result.leak);
  const formats::Bsp& bsp = result.draft.bsp;
  EXPECT_EQ(find_level_fault(result), "");
  EXPECT_EQ(bsp.leaves.size(), 2u);
  EXPECT_EQ(bsp.leaves[1].marksurface_count, 4u * 2 + 2u * 4) << "what is 256 wide is cut at 240 texels";
  EXPECT_EQ(bsp.models[0].visible_leaves, 1);
  EXPECT_EQ(result.draft.portals.cluster_count, 1u);
  EXPECT_THAT(result.draft.portals.portals, ::testing::IsEmpty());
}

// Hull 1 is 32 wide and reaches from 24 below its origin to 32 above, so its walls are that much nearer.
TEST(MakeDraft, ClipHullsKeepBoxesOffTheWalls) {
  const DraftResult result = compile_draft(room_text());
  for (const auto& [hull, side, below, above] :
       {std::tuple(world::Hull::kPlayer, 16.0f, 24.0f, 32.0f), {world::Hull::kLarge, 32.0f, 24.0f, 64.0f}}) {
    const math::Vec3 middle(0, 0, 40);
    EXPECT_EQ(contents_at(result, middle, hull), world::Contents::kEmpty);
    for (const float inside : {1.0f, -1.0f}) {
      const auto expected = inside > 0 ? world::Contents::kEmpty : world::Contents::kSolid;
      EXPECT_EQ(contents_at(result, {128 - side - inside, 0, 40}, hull), expected);
      EXPECT_EQ(contents_at(result, {0, -128 + side + inside, 40}, hull), expected);
      EXPECT_EQ(contents_at(result, {0, 0, below + inside}, hull), expected);
      EXPECT_EQ(contents_at(result, {0, 0, 128 - above - inside}, hull), expected);
    }
  }
}

TEST(MakeDraft, BrushesDecideTheContentsOfLeaves) {
  const Vec3d mins(-64, -64, 0), maxs(64, 64, 48);
  struct Case {
    std::string texture;
    world::Contents contents;
  };
  for (const Case& c : {Case{"*water1", world::Contents::kWater}, Case{"*slime0", world::Contents::kSlime},
                        Case{"*lava1", world::Contents::kLava}, Case{"sky1", world::Contents::kSky},
                        Case{"stone", world::Contents::kSolid}, Case{"clip", world::Contents::kEmpty},
                        Case{"hint", world::Contents::kEmpty}}) {
    const DraftResult result = compile_draft(room_text(box_text(mins, maxs, c.texture)));
    EXPECT_EQ(contents_at(result, {0, 0, 24}), c.contents) << c.texture;
    EXPECT_EQ(contents_at(result, {0, 0, 100}), world::Contents::kEmpty) << c.texture;
    const bool blocks = c.texture == "stone" || c.texture == "clip" || c.texture == "sky1";
    EXPECT_EQ(contents_at(result, {0, 0, 30}, world::Hull::kPlayer) == world::Contents::kSolid, blocks)
        << c.texture;
  }
}

TEST(MakeDraft, SolidWinsOverWaterWhereTheyOverlap) {
  const DraftResult result = compile_draft(room_text(box_text({-64, -64, 0}, {64, 64, 48}, "*water1") +
                                                     box_text({-16, -16, 0}, {16, 16, 64}, "stone")));
  EXPECT_EQ(contents_at(result, {0, 0, 24}), world::Contents::kSolid);
  EXPECT_EQ(contents_at(result, {40, 0, 24}), world::Contents::kWater);
}

// The surface of a liquid is drawn for viewers above and below.
TEST(MakeDraft, WaterHasFacesBothWays) {
  // Lit faces would be cut, since this one is larger than a light map.
  const DraftResult result =
      compile_draft(room_text() + entity_text("func_group", "\"_litwater\" \"0\"",
                                              box_text({-128, -128, 0}, {128, 128, 48}, "*water1")));
  int up = 0, down = 0;
  for (const formats::BspFace& face : result.draft.bsp.faces) {
    const auto& texinfo = result.draft.bsp.texinfos[face.texinfo];
    if (result.draft.bsp.miptexes[static_cast<std::size_t>(texinfo.miptex)].name != "*water1") continue;
    EXPECT_EQ(texinfo.flags, 1);
    ++(face.side == 0 ? up : down);
  }
  EXPECT_EQ(up, 1);
  EXPECT_EQ(down, 1);
}

TEST(MakeDraft, HoleInTheWallIsALeakWithAPath) {
  std::string walls = walls_text(kRoomMins, kRoomMaxs, "wall");
  const std::size_t first_end = walls.find("}\n") + 2;
  const std::string text =
      entity_text("worldspawn", "", walls.substr(first_end)) + point_text("info_player_start", {0, 0, 32});
  const DraftResult result = compile_draft(text);
  ASSERT_TRUE(result.leak);
  EXPECT_EQ(result.leak->classname, "info_player_start");
  EXPECT_EQ(result.leak->entity, 1u);
  const std::size_t before_it = text.find("{\n\"classname\" \"info_player_start\"");
  ASSERT_NE(before_it, std::string::npos);
  EXPECT_EQ(result.leak->line, 1 + std::count(text.begin(), text.begin() + before_it, '\n'));
  EXPECT_EQ(result.leak->points_world.front(), Vec3d(0, 0, 32));
  EXPECT_LE(result.leak->points_world.back().x, -128) << "the wall of the least x is missing";
  EXPECT_EQ(find_level_fault(result), "");
}

// The room is one leaf, which may reach the edge of the tree's box.
TEST(MakeDraft, WayOutEndsOutsideWhicheverWallIsMissing) {
  const std::string walls = walls_text(kRoomMins, kRoomMaxs, "wall");
  std::vector<std::size_t> ends = {0};
  while (ends.back() < walls.size()) ends.push_back(walls.find("}\n", ends.back()) + 2);
  ASSERT_EQ(ends.size(), 7u);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string rest = walls.substr(0, ends[i]) + walls.substr(ends[i + 1]);
    const DraftResult result =
        compile_draft(entity_text("worldspawn", "", rest) + point_text("info_player_start", {0, 0, 32}));
    ASSERT_TRUE(result.leak) << i;
    const Vec3d end = result.leak->points_world.back();
    EXPECT_GE(result.leak->points_world.size(), 2u) << i;
    EXPECT_TRUE(glm::any(glm::lessThanEqual(end, Vec3d(kRoomMins))) ||
                glm::any(glm::greaterThanEqual(end, Vec3d(kRoomMaxs))))
        << i << ": " << end.x << " " << end.y << " " << end.z;
  }
}

TEST(MakeDraft, WithoutEntitiesTheOutsideIsDrawnWithAWarning) {
  const auto draft_warnings = [](const std::string& text) {
    compiler::Warnings warnings;
    EXPECT_TRUE(try_compile_draft(text, warnings).ok());
    return warnings;
  };
  const auto is_about_places = [](const compiler::Warning& warning) {
    return warning.kind == "no entity has an origin";
  };
  const std::string bare = entity_text("worldspawn", "", walls_text(kRoomMins, kRoomMaxs, "wall"));
  EXPECT_EQ(std::ranges::count_if(draft_warnings(bare), is_about_places), 1);
  EXPECT_EQ(std::ranges::count_if(draft_warnings(room_text()), is_about_places), 0);
}

TEST(MakeDraft, BrushEntitiesAreModels) {
  const std::string text =
      room_text() + entity_text("func_door", "\"angle\" \"90\"", box_text({0, 0, 0}, {32, 8, 64}, "door")) +
      entity_text("func_wall", "", box_text({64, 0, 0}, {96, 8, 64}, "wall"));
  const DraftResult result = compile_draft(text);
  ASSERT_EQ(result.draft.bsp.models.size(), 3u);
  EXPECT_EQ(result.draft.bsp.models[1].face_count, 6u);
  const auto entities = formats::read_entities(result.draft.bsp.entities).value();
  EXPECT_EQ(entities[2].find("model"), "*1");
  EXPECT_EQ(entities[3].find("model"), "*2");
  EXPECT_EQ(entities[2].find("angle"), "90");
  EXPECT_TRUE(entities[0].find("wad")) << "Half-Life finds textures by it";
}

TEST(MakeDraft, OriginBrushIsTheCenterOfRotation) {
  const DraftResult result =
      compile_draft(room_text() + entity_text("func_rotate_door", "",
                                              box_text({32, 0, 0}, {64, 8, 64}, "door") +
                                                  box_text({28, 0, 28}, {36, 8, 36}, "origin")));
  const formats::BspModel& door = result.draft.bsp.models[1];
  EXPECT_EQ(door.mins, math::Vec3(0, -4, -32));
  EXPECT_EQ(door.maxs, math::Vec3(32, 4, 32));
  EXPECT_EQ(formats::read_entities(result.draft.bsp.entities).value()[2].find_vec3("origin"),
            math::Vec3(32, 4, 32));
}

TEST(MakeDraft, DetailDoesNotDivideClusters) {
  const std::string pillar = box_text({-16, -16, 0}, {16, 16, 128}, "stone");
  const DraftResult structural = compile_draft(room_text(pillar));
  const DraftResult detail = compile_draft(room_text() + entity_text("func_detail", "", pillar));
  EXPECT_EQ(structural.draft.bsp.leaves.size(), detail.draft.bsp.leaves.size());
  EXPECT_GT(structural.draft.portals.cluster_count, 1u);
  EXPECT_EQ(detail.draft.portals.cluster_count, 1u);
  EXPECT_EQ(detail.draft.bsp.models.size(), 1u);
}

TEST(MakeDraft, WaterMayBeOpaqueToVisibility) {
  const std::string text = room_text(box_text({-128, -128, 0}, {128, 128, 48}, "*water1"));
  EXPECT_EQ(compile_draft(text).draft.portals.portals.size(), 1u);
  EXPECT_EQ(compile_draft(text, {.water_is_transparent = false}).draft.portals.portals.size(), 0u);
}

// One sees the floor below it through its holes.
TEST(MakeDraft, FenceIsSolidButHidesNothing) {
  const std::string block = box_text({-32, -32, 0}, {32, 32, 64}, "{grate");
  const DraftResult result = compile_draft(room_text() + entity_text("func_detail_fence", "", block));
  EXPECT_EQ(contents_at(result, {0, 0, 32}), world::Contents::kSolid);
  EXPECT_EQ(contents_at(result, {0, 0, 80}, world::Hull::kPlayer), world::Contents::kSolid);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "{grate", 64), 64 * 64);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "wall", 0), kFloorArea);
  const DraftResult solid = compile_draft(room_text() + entity_text("func_detail", "", block));
  EXPECT_DOUBLE_EQ(measure_area_looking_up(solid, "wall", 0), kFloorArea - 64 * 64)
      << "what nobody can see is left out";
}

TEST(MakeDraft, IllusionaryIsDrawnButNotSolid) {
  const DraftResult result =
      compile_draft(room_text() + entity_text("func_detail_illusionary", "",
                                              box_text({-32, -32, 0}, {32, 32, 64}, "bush")));
  EXPECT_EQ(contents_at(result, {0, 0, 32}), world::Contents::kEmpty);
  EXPECT_EQ(contents_at(result, {0, 0, 32}, world::Hull::kPlayer), world::Contents::kEmpty);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "bush", 64), 64 * 64);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "wall", 0), kFloorArea);
}

TEST(MakeDraft, LaterBrushShowsWhereTwoOverlap) {
  const std::string early = box_text({-64, -64, 0}, {64, 64, 32}, "early");
  const std::string late = box_text({0, -64, 0}, {96, 64, 32}, "late");
  const DraftResult result = compile_draft(room_text(early + late));
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "early", 32), 64 * 128);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "late", 32), 96 * 128);
}

// The sides of a hint brush cut the room and leave nothing else behind; its hintskip sides do not even cut.
TEST(MakeDraft, HintsOnlyCut) {
  std::string hint = box_text({-128, -128, 64}, {128, 128, 128}, "hintskip");
  const DraftResult without = compile_draft(room_text());
  const DraftResult skipped = compile_draft(room_text(hint));
  EXPECT_EQ(skipped.draft.bsp.leaves.size(), without.draft.bsp.leaves.size());
  hint.replace(hint.find("hintskip"), 8, "hint");  // the side at the minimum x, along the wall
  for (std::size_t at = hint.rfind("hintskip"); at != std::string::npos; at = hint.rfind("hintskip"))
    hint.replace(at, 8, "hint");
  const DraftResult cut = compile_draft(room_text(hint));
  EXPECT_EQ(cut.draft.bsp.leaves.size(), without.draft.bsp.leaves.size() + 1);
  EXPECT_EQ(cut.draft.portals.cluster_count, 2u);
  ASSERT_EQ(cut.draft.portals.portals.size(), 1u);
  EXPECT_EQ(cut.draft.portals.portals[0].normal, Vec3d(0, 0, 1));
  EXPECT_EQ(cut.draft.portals.portals[0].distance, 64);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(cut, "wall", 0), kFloorArea);
}

TEST(MakeDraft, DoesNotDependOnThreads) {
  std::string text = room_text();
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const Vec3d at(random.uniform(-100, 60), random.uniform(-100, 60), random.uniform(0, 60));
    text += entity_text(i % 3 == 0   ? "func_detail"
                        : i % 3 == 1 ? "func_wall"
                                     : "func_group",
                        "", box_text(at, at + Vec3d(30, 25, 20), "stone"));
  }
  const DraftResult one = compile_draft(text, {}, 1);
  for (const int threads : {2, 8})
    EXPECT_TRUE(compile_draft(text, {}, threads).draft.bsp == one.draft.bsp) << threads;
}

TEST(MakeDraft, BadBrushesAreLeftOutWithAWarning) {
  const std::string good = walls_text(kRoomMins, kRoomMaxs, "wall");
  struct Case {
    const char* brush;
    const char* kind;
  };
  const Case cases[] = {
      {"{\n}\n", "brush without volume"},
      {"{\n( 0 0 0 ) ( 0 1 0 ) ( 0 0 1 ) a 0 0 0 1 1\n( 4 0 0 ) ( 4 0 1 ) ( 4 1 0 ) a 0 0 0 1 1\n}\n",
       "brush without volume"},
      {"{\n( 0 0 0 ) ( 0 0 0 ) ( 0 0 1 ) a 0 0 0 1 1\n}\n", "side without area, ignored"},
  };
  for (const Case& c : cases) {
    compiler::Warnings warnings;
    const auto result = try_compile_draft(
        entity_text("worldspawn", "", good + c.brush) + point_text("info_player_start", {0, 0, 32}),
        warnings);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result.value().draft.bsp.faces.size(), compile_draft(room_text()).draft.bsp.faces.size());
    ASSERT_FALSE(warnings.empty());
    EXPECT_THAT(warnings.back().kind, ::testing::HasSubstr("brush without volume"));
    EXPECT_THAT(warnings.front().kind, ::testing::HasSubstr(c.kind));
    EXPECT_THAT(warnings.front().what, ::testing::HasSubstr("entity 0, brush 6, line"));
  }
}

TEST(MakeDraft, MapsWithoutAWorldAreErrors) {
  for (const std::string& text :
       {std::string{}, point_text("light", {0, 0, 0}), entity_text("worldspawn", "")}) {
    compiler::Warnings warnings;
    EXPECT_FALSE(try_compile_draft(text, warnings).ok());
  }
}

TEST(MakeDraft, ReportsProgress) {
  std::vector<std::size_t> steps;
  std::size_t of = 0;
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  compiler::Warnings warnings;
  const auto size = [](std::string_view) { return math::Vec2d(64); };
  ASSERT_TRUE(compiler::make_draft(parse_map(room_text(box_text({0, 0, 0}, {16, 16, 16}, "block"))), size, {},
                                   jobs, warnings,
                                   [&](std::size_t done, std::size_t total) {
                                     steps.push_back(done);
                                     of = total;
                                     return true;
                                   })
                  .ok());
  ASSERT_GT(steps.size(), 10u);
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
  EXPECT_GE(steps.back() + 1, of) << "except for rounding";
}

}  // namespace
}  // namespace temblor::test
