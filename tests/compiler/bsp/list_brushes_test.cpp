// The lump BRUSHLIST against the map's brushes and the compiled hulls.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/drafts.h"
#include "formats/bspx/brush_list.h"
#include "support/effort.h"
#include "support/levels/room_map.h"
#include "world/level.h"

namespace temblor::test {
namespace {

std::vector<formats::ListedModel> read_list(const formats::Bsp& bsp) {
  const formats::BspxLump* lump = bsp.find_bspx(formats::kBrushListLump);
  return lump == nullptr ? std::vector<formats::ListedModel>{} : formats::read_brush_list(lump->data).value();
}

bool contains(const formats::ListedBrush& brush, const math::Vec3& point) {
  return glm::all(glm::greaterThan(point, brush.mins)) && glm::all(glm::lessThan(point, brush.maxs)) &&
         std::ranges::all_of(brush.planes, [&](const formats::ListedPlane& plane) {
           return glm::dot(plane.normal, point) < plane.distance;
         });
}

// The contents at a point: the first of these that a brush there has. -1: empty.
int listed_contents(const formats::ListedModel& model, const math::Vec3& point) {
  for (const int contents : {-2, -6, -5, -4, -3})
    for (const formats::ListedBrush& brush : model.brushes)
      if (brush.contents == contents && contains(brush, point)) return contents;
  return -1;
}

// A prism with a sloped side: below the line from (0, 0) to (64, 64) in x and z, 64 units deep.
std::string wedge_text(const math::Vec3d& at, std::string_view texture) {
  const auto point = [&](double x, double y, double z) {
    return fmt::format("( {} {} {} ) ", at.x + x, at.y + y, at.z + z);
  };
  const auto side = [&](const std::string& points) {
    return points + fmt::format("{} 0 0 0 1 1\n", texture);
  };
  return "{\n" + side(point(0, 0, 0) + point(1, 0, 0) + point(0, 1, 0)) +
         side(point(64, 0, 0) + point(64, 0, 1) + point(64, 1, 0)) +
         side(point(0, 0, 0) + point(0, 0, 1) + point(1, 0, 0)) +
         side(point(0, 64, 0) + point(1, 64, 0) + point(0, 64, 1)) +
         side(point(0, 0, 0) + point(0, 1, 0) + point(1, 0, 1)) + "}\n";
}

std::string map_of_all_kinds() {
  const std::string world =
      box_text({-100, -100, 0}, {-60, -60, 60}, "wall") + box_text({0, -100, 0}, {60, -40, 30}, "*water") +
      box_text({80, -100, 90}, {120, -40, 128}, "sky1") + box_text({-20, 40, 0}, {20, 80, 40}, "clip") +
      wedge_text({-100, 20, 0}, "wall") + box_text({40, 60, 0}, {50, 70, 80}, "hint");
  return room_text(world) + entity_text("func_detail", "", box_text({60, 60, 0}, {110, 110, 40}, "wall")) +
         entity_text("func_detail_illusionary", "", box_text({-60, -20, 0}, {-30, 10, 40}, "wall")) +
         entity_text("func_door", "", box_text({-10, 100, 0}, {10, 120, 64}, "door")) +
         entity_text("func_illusionary", "", box_text({30, 100, 0}, {50, 120, 64}, "door"));
}

TEST(ListBrushes, AgreesWithTheDrawnHull) {
  const compiler::DraftResult result = compile_draft(map_of_all_kinds(), {.brush_list = true});
  const std::vector<formats::ListedModel> models = read_list(result.draft.bsp);
  ASSERT_GE(models.size(), 2u);
  EXPECT_EQ(models[0].model, 0u);
  const auto level = world::make_level(result.draft.bsp, "room").value();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> x(-127, 127), z(1, 127);
  int filled = 0;
  for (int i = 0; i < effort(20000, 2000); ++i) {
    const math::Vec3 point(x(random), x(random), z(random));
    const int expected =
        static_cast<int>(world::hull_contents(*level, world::ModelIndex{0}, world::Hull::kPoint, point));
    ASSERT_EQ(listed_contents(models[0], point), expected) << point.x << " " << point.y << " " << point.z;
    filled += expected != -1 ? 1 : 0;
  }
  EXPECT_GT(filled, effort(500, 50));
}

TEST(ListBrushes, ListsBoxesWithoutPlanesAndSlopesWithOne) {
  const formats::Bsp bsp = compile_draft(map_of_all_kinds(), {.brush_list = true}).draft.bsp;
  const std::vector<formats::ListedModel> models = read_list(bsp);
  std::size_t sloped = 0, clips = 0;
  for (const formats::ListedBrush& brush : models[0].brushes) {
    clips += brush.contents == formats::kClipContents ? 1 : 0;
    if (brush.planes.empty()) continue;
    ++sloped;
    ASSERT_EQ(brush.planes.size(), 1u);
    EXPECT_NEAR(glm::dot(brush.planes[0].normal, math::Vec3(-1, 0, 1)), std::sqrt(2), 1e-5);
    EXPECT_EQ(brush.mins, math::Vec3(-100, 20, 0));
    EXPECT_EQ(brush.maxs, math::Vec3(-36, 84, 64));
  }
  EXPECT_EQ(sloped, 1u);
  EXPECT_EQ(clips, 1u);
  // Six walls, a pillar, water, sky, clip, a wedge, and detail; neither hint nor illusionary.
  EXPECT_EQ(models[0].brushes.size(), 12u);
  const auto door = std::ranges::find(models, 1u, &formats::ListedModel::model);
  ASSERT_NE(door, models.end());
  EXPECT_EQ(door->brushes.at(0).mins, math::Vec3(-10, 100, 0));
}

TEST(ListBrushes, IsOnlyWrittenOnRequest) {
  const compiler::DraftResult result = compile_draft(map_of_all_kinds());
  EXPECT_EQ(result.draft.bsp.find_bspx(formats::kBrushListLump), nullptr);
}

}  // namespace
}  // namespace temblor::test
