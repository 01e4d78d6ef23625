// The kinds of brushes: special textures, the func_detail family, and keys of brushes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/drafts.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using compiler::DraftResult;
using math::Vec3d;
using world::Contents;
using world::Hull;

const std::string kBlock = box_text({-32, -32, 0}, {32, 32, 64}, "stone");
constexpr double kBlockSide = 64 * 64;

std::string room_with_entity(std::string_view classname, std::string_view fields,
                             const std::string& brushes) {
  return room_text() + entity_text(classname, fields, brushes);
}

std::string box_with(const Vec3d& mins, const Vec3d& maxs, std::string_view texture,
                     std::string_view from_now_on, int sides_before) {
  std::string text = box_text(mins, maxs, texture);
  std::size_t at = 0;
  for (int side = 0; (at = text.find(texture, at)) != std::string::npos; at += from_now_on.size(), ++side)
    if (side >= sides_before)
      text.replace(at, texture.size(), from_now_on);
    else
      at += texture.size() - from_now_on.size();
  return text;
}

bool is_marked(const formats::Bsp& bsp, std::uint32_t face) {
  return std::ranges::find(bsp.marksurfaces, face) != bsp.marksurfaces.end();
}

TEST(BrushKinds, DetailWallCutsNoFloor) {
  const DraftResult empty = compile_draft(room_text());
  const DraftResult wall = compile_draft(room_with_entity("func_detail_wall", "", kBlock));
  EXPECT_EQ(contents_at(wall, {0, 0, 32}), Contents::kSolid);
  EXPECT_EQ(contents_at(wall, {0, 0, 80}, Hull::kPlayer), Contents::kSolid);
  EXPECT_EQ(count_faces(wall, "wall"), count_faces(empty, "wall"));
  EXPECT_DOUBLE_EQ(measure_area_looking_up(wall, "wall", 0), kFloorArea);
  EXPECT_EQ(count_faces(wall, "stone"), 5);
  EXPECT_EQ(wall.draft.portals.cluster_count, 1u);
}

TEST(BrushKinds, DetailWallHidesWhatItCovers) {
  const std::string slab = box_text({-20, -20, -4}, {20, 20, 8}, "slab");
  EXPECT_GT(count_faces(compile_draft(room_text(slab)), "slab"), 0);
  EXPECT_EQ(count_faces(compile_draft(room_text(slab) + entity_text("func_detail_wall", "", kBlock)), "slab"),
            0);
}

// One sees what it covers through its holes, though it has no leaf that could list it.
TEST(BrushKinds, FenceShowsWhatItCovers) {
  const std::string slab = box_text({-20, -20, -4}, {20, 20, 8}, "slab");
  const DraftResult result = compile_draft(room_text(slab) + entity_text("func_detail_fence", "", kBlock));
  EXPECT_EQ(find_level_fault(result), "");
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "slab", 8), 40 * 40);
  EXPECT_EQ(count_faces(result, "slab"), 5);
  const formats::Bsp& bsp = result.draft.bsp;
  for (std::uint32_t face = 0; face < bsp.faces.size(); ++face) EXPECT_TRUE(is_marked(bsp, face)) << face;
}

TEST(BrushKinds, MirrorInsideDrawsFacesBothWays) {
  for (const char* classname : {"func_detail_fence", "func_detail_illusionary", "func_wall", "func_door"}) {
    const DraftResult once = compile_draft(room_with_entity(classname, "", kBlock));
    const DraftResult both = compile_draft(room_with_entity(classname, "\"_mirrorinside\" \"1\"", kBlock));
    EXPECT_EQ(find_level_fault(both), "") << classname;
    EXPECT_EQ(measure_area(once, "stone", 0, 1, -32), 0) << classname;
    EXPECT_DOUBLE_EQ(measure_area(both, "stone", 0, 1, -32), kBlockSide) << classname;
    EXPECT_DOUBLE_EQ(measure_area(both, "stone", 0, -1, -32), kBlockSide) << classname;
    EXPECT_DOUBLE_EQ(measure_area_looking_up(both, "stone", 64), kBlockSide) << classname;
    EXPECT_DOUBLE_EQ(measure_area(both, "stone", 2, -1, 64), kBlockSide) << classname;
    EXPECT_EQ(contents_at(once, {0, 0, 32}), contents_at(both, {0, 0, 32})) << classname;
  }
}

TEST(BrushKinds, NoClipFacesKeepsFacesBetweenBrushes) {
  const std::string two =
      box_text({-64, -32, 0}, {0, 32, 64}, "left") + box_text({0, -32, 0}, {64, 32, 64}, "right");
  for (const char* classname : {"func_detail_fence", "func_detail_illusionary", "func_wall"}) {
    const DraftResult clipped = compile_draft(room_with_entity(classname, "", two));
    EXPECT_EQ(measure_area(clipped, "left", 0, 1, 0), 0) << classname;
    const DraftResult kept = compile_draft(room_with_entity(classname, "\"_noclipfaces\" \"1\"", two));
    EXPECT_EQ(find_level_fault(kept), "") << classname;
    EXPECT_DOUBLE_EQ(measure_area(kept, "left", 0, 1, 0), kBlockSide) << classname;
    EXPECT_DOUBLE_EQ(measure_area(kept, "right", 0, -1, 0), kBlockSide) << classname;
  }
}

TEST(BrushKinds, ChopOrderDecidesWhichBrushShows) {
  const auto group = [](const char* order, double x, const char* texture) {
    return entity_text("func_group", fmt::format("\"_chop_order\" \"{}\"", order),
                       box_text({x, -32, 0}, {x + 64, 32, 64}, texture));
  };
  for (const auto& [first, second, first_shows] : {std::tuple("0", "0", false),
                                                   {"1", "0", true},
                                                   {"0", "-1", true},
                                                   {"1", "2", false},
                                                   {"x", "0", false}}) {
    const DraftResult result =
        compile_draft(room_text() + group(first, -48, "first") + group(second, -16, "second"));
    EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "first", 64), first_shows ? 64 * 64 : 32 * 64);
    EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "second", 64), first_shows ? 32 * 64 : 64 * 64);
  }
}

TEST(BrushKinds, HullsDecideWhatABrushStops) {
  for (const auto& [key, stops_points, stops_players, stops_large] : {std::tuple("0", true, true, true),
                                                                      {"1", true, false, false},
                                                                      {"2", false, true, false},
                                                                      {"3", true, true, false},
                                                                      {"4", false, false, true},
                                                                      {"7", true, true, true},
                                                                      {"8", false, false, false},
                                                                      {"-1", true, true, true},
                                                                      {"nan", true, true, true},
                                                                      {"1e30", false, false, false}}) {
    const DraftResult result =
        compile_draft(room_with_entity("func_detail", fmt::format("\"_hulls\" \"{}\"", key), kBlock));
    const auto contents = [](bool stops) { return stops ? Contents::kSolid : Contents::kEmpty; };
    EXPECT_EQ(contents_at(result, {0, 0, 40}), contents(stops_points)) << key;
    EXPECT_EQ(contents_at(result, {0, 0, 40}, Hull::kPlayer), contents(stops_players)) << key;
    EXPECT_EQ(contents_at(result, {0, 0, 40}, Hull::kLarge), contents(stops_large)) << key;
    EXPECT_EQ(count_faces(result, "stone"), stops_points ? 5 : 0) << key;
  }
}

// It is as wide as the room, so neither half of the room sees the other.
TEST(BrushKinds, VisBlockerIsOpaqueButNotSolid) {
  const std::string curtain = box_text({-16, -128, 0}, {16, 128, 128}, "cloth");
  const DraftResult result = compile_draft(room_with_entity("func_illusionary_visblocker", "", curtain));
  EXPECT_FALSE(result.leak);
  EXPECT_EQ(contents_at(result, {0, 0, 64}), Contents::kEmpty);
  EXPECT_EQ(contents_at(result, {0, 0, 64}, Hull::kPlayer), Contents::kEmpty);
  EXPECT_EQ(result.draft.portals.cluster_count, 3u);
  EXPECT_TRUE(result.draft.portals.portals.empty());
  EXPECT_DOUBLE_EQ(measure_area(result, "cloth", 0, 1, 16), 256 * 128);
  EXPECT_DOUBLE_EQ(measure_area(result, "cloth", 0, -1, 16), 256 * 128) << "from inside";
  EXPECT_EQ(result.draft.bsp.models.size(), 1u);
}

TEST(BrushKinds, IllusionaryShowsInWater) {
  const std::string water = box_text({-128, -128, 0}, {128, 128, 48}, "*water");
  const DraftResult result =
      compile_draft(room_text(water) + entity_text("func_detail_illusionary", "", kBlock));
  EXPECT_EQ(contents_at(result, {0, 0, 24}), Contents::kWater);
  EXPECT_EQ(contents_at(result, {0, 0, 56}), Contents::kEmpty);
  EXPECT_DOUBLE_EQ(measure_area(result, "stone", 0, 1, 32), kBlockSide);
  EXPECT_DOUBLE_EQ(measure_area(result, "stone", 1, -1, -32), kBlockSide);
  EXPECT_DOUBLE_EQ(measure_area_looking_up(result, "*water", 48), kFloorArea);
}

// A side that is not drawn does not change the brush.
TEST(BrushKinds, SkippedSidesAreNotDrawn) {
  struct Case {
    const char* texture;
    const char* skipped;
    Contents contents;
    int faces;  // of the sides at the minimum x, y and z; the last one is on the floor
  };
  for (const Case& c : {Case{"stone", "skip", Contents::kSolid, 2},
                        {"stone", "CAULK", Contents::kSolid, 2},
                        {"stone", "nodraw", Contents::kSolid, 2},
                        {"stone", "hintskip", Contents::kSolid, 2},
                        {"*lava", "*lavaskip", Contents::kLava, 4},
                        {"*water", "*waterSkip", Contents::kWater, 4},
                        {"*slime", "*slimeskip", Contents::kSlime, 4}}) {
    const DraftResult result =
        compile_draft(room_text(box_with({-32, -32, 0}, {32, 32, 64}, c.texture, c.skipped, 3)));
    EXPECT_EQ(find_level_fault(result), "") << c.skipped;
    EXPECT_EQ(contents_at(result, {0, 0, 32}), c.contents) << c.skipped;
    EXPECT_EQ(count_faces(result, c.texture), c.faces) << c.skipped;
    EXPECT_EQ(count_faces(result, c.skipped), 0) << c.skipped;
  }
  const DraftResult all = compile_draft(room_text(box_text({-32, -32, 0}, {32, 32, 64}, "skip")));
  EXPECT_EQ(contents_at(all, {0, 0, 32}), Contents::kSolid);
  EXPECT_EQ(contents_at(all, {0, 0, 70}, Hull::kPlayer), Contents::kSolid);
}

// A model without any face: points pass through it, boxes do not.
TEST(BrushKinds, ClipAloneMakesAModelThatPointsPass) {
  const DraftResult result =
      compile_draft(room_with_entity("func_wall", "", box_text({-32, -32, 0}, {32, 32, 64}, "clip")));
  EXPECT_EQ(find_level_fault(result), "");
  ASSERT_EQ(result.draft.bsp.models.size(), 2u);
  EXPECT_GE(result.draft.bsp.models[1].head_nodes[0], 0)
      << "engines read a leaf's number there as what is in it";
  const auto level = world::make_level(result.draft.bsp, "room").value();
  const auto in_model = [&](Hull hull) {
    return world::hull_contents(*level, world::ModelIndex{1}, hull, {0, 0, 32});
  };
  EXPECT_EQ(in_model(Hull::kPoint), Contents::kEmpty);
  EXPECT_EQ(in_model(Hull::kPlayer), Contents::kSolid);
}

// Only the world decides the contents of a place, as in other compilers.
TEST(BrushKinds, LiquidAndSkyOfABrushEntityAreSolid) {
  for (const char* texture : {"*water", "sky1"}) {
    const DraftResult result =
        compile_draft(room_with_entity("func_wall", "", box_text({-32, -32, 0}, {32, 32, 64}, texture)));
    const auto level = world::make_level(result.draft.bsp, "room").value();
    for (const Hull hull : {Hull::kPoint, Hull::kPlayer})
      EXPECT_EQ(world::hull_contents(*level, world::ModelIndex{1}, hull, {0, 0, 32}), Contents::kSolid)
          << texture;
    EXPECT_EQ(count_faces(result, texture), 6) << "none seen from inside";
  }
}

TEST(BrushKinds, HintOutsideTheLevelDoesNothing) {
  const DraftResult without = compile_draft(room_text());
  const DraftResult with = compile_draft(room_text(box_text({400, 400, 400}, {500, 500, 500}, "hint")));
  EXPECT_FALSE(with.leak);
  EXPECT_EQ(with.draft.bsp.leaves.size(), without.draft.bsp.leaves.size());
  EXPECT_EQ(with.draft.bsp.faces.size(), without.draft.bsp.faces.size());
}

// DarkPlaces refuses nodes with equal children. Between a fence and a wall, both sides are solid.
TEST(BrushKinds, NodesBetweenAFenceAndAWallHaveTwoChildren) {
  const DraftResult result =
      compile_draft(room_text() + entity_text("func_detail_fence", "",
                                              box_text({-32, -32, 0}, {32, 32, 64}, "{fence") +
                                                  box_text({0, -32, 32}, {64, 32, 96}, "{other")));
  EXPECT_EQ(find_level_fault(result), "");
  const formats::Bsp& bsp = result.draft.bsp;
  int between_solids = 0;
  for (const formats::BspNode& node : bsp.nodes) {
    EXPECT_NE(node.children[0], node.children[1]);
    const auto is_solid = [&](std::int32_t child) {
      constexpr std::int32_t kSolidContents = -2;
      return child < 0 && bsp.leaves[static_cast<std::size_t>(~child)].contents == kSolidContents;
    };
    between_solids += is_solid(node.children[0]) && is_solid(node.children[1]) ? 1 : 0;
  }
  EXPECT_GT(between_solids, 0) << "the test has such nodes";
}

}  // namespace
}  // namespace temblor::test
