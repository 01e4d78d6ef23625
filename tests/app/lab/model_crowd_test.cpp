// Models before the camera: how many, how far away, and which.
#include "app/lab/model_crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/angles.h"
#include "support/random.h"

namespace temblor::test {
namespace {

app::ModelCrowd load_crowd(int count, double distance) {
  app::CrowdOptions options;
  options.count = count;
  options.distance = distance;
  return app::ModelCrowd::load(options, {}, {}).value();
}

// The middle of a model's box, in the camera's right, up, and forward.
math::Vec3d find_middle(const render::AliasInstance& instance, const render::Camera& camera) {
  const math::Bounds& bounds = render::model_bounds(*instance.model);
  const math::Vec3d middle = math::Vec3d(bounds.mins + bounds.maxs) * 0.5;
  const math::Basis turn = math::basis_from_angles(instance.angles_deg);
  const math::Vec3d d = math::Vec3d(instance.origin_world) - math::Vec3d(camera.origin_world) +
                        turn.forward * middle.x - turn.right * middle.y + turn.up * middle.z;
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  return {glm::dot(d, axes.right), glm::dot(d, axes.up), glm::dot(d, axes.forward)};
}

TEST(ModelCrowd, StandsInView) {
  for (const int count : {1, 2, 10, 100, 1000})
    for (const double distance : {3.0, 30.0, 300.0, 3000.0}) {
      const app::ModelCrowd crowd = load_crowd(count, distance);
      Random random(static_cast<std::uint64_t>(count));
      render::Camera camera;
      camera.origin_world = random.in_cube(1000);
      camera.angles_deg = random.in_cube(180);
      const auto models = crowd.place(camera, 0);
      ASSERT_EQ(models.size(), static_cast<std::size_t>(count));
      double nearest = 1e9;
      for (const render::AliasInstance& instance : models) {
        const math::Vec3d at = find_middle(instance, camera);
        nearest = std::min(nearest, at.z);
        // Half a place to the side of the outermost columns, where half of the layers stand.
        constexpr double kPlace = 60;
        EXPECT_LE(std::abs(at.x), at.z + kPlace) << count << " at " << distance;
        EXPECT_LE(std::abs(at.y), 0.75 * at.z + kPlace) << count << " at " << distance;
      }
      EXPECT_NEAR(nearest, distance, 0.01);
    }
}

TEST(ModelCrowd, DiffersInDirectionAndPose) {
  const app::ModelCrowd crowd = load_crowd(20, 100);
  const auto models = crowd.place({}, 0);
  std::set<float> yaws, blends;
  for (const render::AliasInstance& instance : models) {
    yaws.insert(instance.angles_deg.y);
    blends.insert(instance.blend);
    EXPECT_GE(instance.blend, 0);
    EXPECT_LE(instance.blend, 1);
  }
  EXPECT_EQ(yaws.size(), 20u);
  EXPECT_EQ(blends.size(), 20u);
}

TEST(ModelCrowd, MovesFromMomentToMoment) {
  const app::ModelCrowd crowd = load_crowd(20, 100);
  const auto before = crowd.place({}, 1), again = crowd.place({}, 1), after = crowd.place({}, 2);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].origin_world, again[i].origin_world);
    EXPECT_NE(before[i].angles_deg, after[i].angles_deg);
    const float walked = glm::distance(before[i].origin_world, after[i].origin_world);
    EXPECT_GT(walked, 1);
    EXPECT_LT(walked, 20);
  }
}

TEST(ModelCrowd, HasAModelWithoutGameData) {
  const formats::Mdl mdl = app::make_lumpy_figure();
  EXPECT_EQ(mdl.triangles.size(), 400u);
  EXPECT_EQ(mdl.frames.size(), 4u);
  const auto model = render::make_alias_model(mdl, "figure");
  const math::Bounds& bounds = render::model_bounds(*model);
  EXPECT_NEAR(bounds.maxs.z - bounds.mins.z, 56, 6);
}

}  // namespace
}  // namespace temblor::test
