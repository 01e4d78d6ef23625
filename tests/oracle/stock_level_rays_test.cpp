// Stock levels are sealed: from any open point every ray meets the front of a face, and the space just before
// it is open. This checks the oracle's rays and faces against the level's tree, which they do not use.
#include <gtest/gtest.h>

#include "oracle/rays/ray_scene.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"
#include "world/visibility.h"

namespace temblor::oracle {
namespace {

class StockLevelRays : public testing::TestWithParam<const char*> {};

TEST_P(StockLevelRays, MeetAFaceBeforeAnythingSolid) {
  DATA_FOLDER_OR_SKIP(data);
  const test::DrawableLevel drawable = test::stock_level(data, GetParam());
  const world::Level& level = *drawable.level;
  const PreparedLevel prepared(level);
  const RayScene scene(prepared, {});
  test::Random random(1);
  int escaped = 0, from_solid = 0;
  const int rays = test::effort(100000, 5000);
  for (int i = 0; i < rays; ++i) {
    const render::Camera camera = test::random_camera(level, random);
    const Ray ray = CameraRays(camera, 1, 1).ray(0, 0);
    const auto hit = scene.nearest(ray, 0);
    if (!hit) {
      ++escaped;
      continue;
    }
    const world::Contents before = world::point_contents(level, math::Vec3(ray.at(hit->distance - 0.1)));
    if (hit->distance > 0.2 && before == world::Contents::kSolid) ++from_solid;
  }
  EXPECT_EQ(escaped, 0);
  EXPECT_EQ(from_solid, 0);
}

INSTANTIATE_TEST_SUITE_P(Levels, StockLevelRays, testing::Values("start", "lq_e0m1", "lq_e1m2"));

}  // namespace
}  // namespace temblor::oracle
