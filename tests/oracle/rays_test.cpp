// The oracle's rays and the nearest faces they hit, in levels small enough to know the answer.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "oracle/polygon_level.h"
#include "oracle/rays/ray_scene.h"
#include "support/random.h"

namespace temblor::oracle {
namespace {

constexpr double kNear = 1.0 / 16;

// Facing -x, at the given x, reaching `half` units from the axis in y and z.
PolygonVertices square_facing_minus_x(float x, float half) {
  return {{x, half, -half}, {x, half, half}, {x, -half, half}, {x, -half, -half}};
}

Ray ray_along_x(double y, double z) {
  return {{0, y, z}, {1, 0, 0}};
}

double angle_deg(const math::Vec3d& a, const math::Vec3d& b) {
  return std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b))) * 180 / std::numbers::pi;
}

struct Screen {
  int width, height;
  double horizontal_deg, vertical_deg;  // from border to border, for a field of view of 90
};

class CameraRaysOfScreen : public testing::TestWithParam<Screen> {};

TEST_P(CameraRaysOfScreen, SpanTheFieldOfView) {
  const auto [width, height, horizontal_deg, vertical_deg] = GetParam();
  const CameraRays rays({.fov_deg = 90}, width, height);
  const double middle_x = (width - 1) / 2.0, middle_y = (height - 1) / 2.0;
  EXPECT_NEAR(angle_deg(rays.ray(-0.5, middle_y).direction, rays.ray(width - 0.5, middle_y).direction),
              horizontal_deg, 1e-9);
  EXPECT_NEAR(angle_deg(rays.ray(middle_x, -0.5).direction, rays.ray(middle_x, height - 0.5).direction),
              vertical_deg, 1e-9);
}

// 4:3 has 90 degrees horizontally, and 2 atan(3/4) = 73.74 vertically. 8:3 sees 2 atan(2) horizontally at the
// same height, 4:6 twice the tangent vertically at the same width.
INSTANTIATE_TEST_SUITE_P(Shapes, CameraRaysOfScreen,
                         testing::Values(Screen{320, 240, 90, 73.739795291688},
                                         Screen{640, 240, 126.869897645844, 73.739795291688},
                                         Screen{320, 480, 90, 112.619864948040}));

TEST(CameraRays, FollowTheCamera) {
  const CameraRays ahead({.origin_world = {1, 2, 3}}, 101, 75);
  EXPECT_EQ(ahead.ray(50, 37).origin, math::Vec3d(1, 2, 3));
  EXPECT_EQ(ahead.ray(50, 37).direction, math::Vec3d(1, 0, 0));
  EXPECT_LT(ahead.ray(60, 37).direction.y, 0) << "right of +x is -y";
  EXPECT_LT(ahead.ray(50, 47).direction.z, 0) << "rows run down";
  const CameraRays down({.angles_deg = {90, 0, 0}}, 101, 75);
  EXPECT_NEAR(down.ray(50, 37).direction.z, -1, 1e-12) << "positive pitch looks down";
}

TEST(CameraRays, AreParallelInOrthographicProjection) {
  const CameraRays rays({.projection = render::Projection::kOrthographic, .units_per_pixel = 2}, 101, 75);
  const Ray ray = rays.ray(60, 27);
  EXPECT_EQ(ray.direction, math::Vec3d(1, 0, 0));
  EXPECT_EQ(ray.origin, math::Vec3d(0, -20, 20));
}

TEST(FaceTree, SeesFrontsOnly) {
  const std::array models = {PolygonModel{{square_facing_minus_x(10, 5)}}};
  const world::Level level = make_polygon_level(models);
  const FaceTree tree(level, level.world());
  const auto any = [](const FaceHit&) { return true; };
  const auto hit = tree.nearest(ray_along_x(1, 2), kNear, any);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance, 10);
  EXPECT_FALSE(tree.nearest({{20, 1, 2}, {-1, 0, 0}}, kNear, any)) << "from behind";
  EXPECT_FALSE(tree.nearest(ray_along_x(5.5, 0), kNear, any)) << "beside it";
  EXPECT_FALSE(tree.nearest(ray_along_x(1, 2), 10.5, any)) << "before the near plane";
}

TEST(FaceTree, TakesTheNearestThatIsAccepted) {
  const std::array models = {PolygonModel{{square_facing_minus_x(30, 5), square_facing_minus_x(10, 5)}}};
  const world::Level level = make_polygon_level(models);
  const FaceTree tree(level, level.world());
  EXPECT_EQ(tree.nearest(ray_along_x(0, 0), kNear, [](const FaceHit&) { return true; })->face,
            world::FaceIndex{1});
  EXPECT_EQ(
      tree.nearest(ray_along_x(0, 0), kNear, [](const FaceHit& hit) { return hit.distance > 20; })->face,
      world::FaceIndex{0});
}

TEST(FaceTree, KnowsConcaveFaces) {
  // An L in the plane x = 10: the square from 0 to 4 without its upper right quarter (y > 2 and z > 2).
  const PolygonVertices l_shape = {{10, 0, 0}, {10, 4, 0}, {10, 4, 2}, {10, 2, 2}, {10, 2, 4}, {10, 0, 4}};
  const std::array models = {PolygonModel{{l_shape}}};
  const world::Level level = make_polygon_level(models);
  ASSERT_FLOAT_EQ(level.planes[0].normal.x, -1);
  const FaceTree tree(level, level.world());
  test::Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const double y = random.uniform(-1, 5), z = random.uniform(-1, 5);
    const bool in_l = y > 0 && z > 0 && y < 4 && z < 4 && (y < 2 || z < 2);
    EXPECT_EQ(tree.distance_to(ray_along_x(y, z), world::FaceIndex{0}).has_value(), in_l) << y << " " << z;
  }
}

// Barycentric coordinates: another way to test whether a ray meets a triangle.
std::optional<double> meet_triangle(const Ray& ray, const PolygonVertices& triangle) {
  const math::Vec3d a(triangle[0]), ab = math::Vec3d(triangle[1]) - a, ac = math::Vec3d(triangle[2]) - a;
  const math::Vec3d across = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, across);
  if (determinant >= 0) return std::nullopt;  // clockwise as seen from the ray: negative
  const math::Vec3d from_a = ray.origin - a, up = glm::cross(from_a, ab);
  const double u = glm::dot(from_a, across) / determinant, v = glm::dot(ray.direction, up) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
  return glm::dot(ac, up) / determinant;
}

TEST(FaceTree, AgreesWithLookingAtEveryTriangle) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    PolygonModel model;
    const std::size_t count = 1 + random.below(300);
    for (std::size_t i = 0; i < count; ++i) {
      const math::Vec3 middle = random.in_cube(100);
      model.polygons.push_back(
          {middle + random.in_cube(20), middle + random.in_cube(20), middle + random.in_cube(20)});
    }
    const std::array models = {model};
    const world::Level level = make_polygon_level(models);
    const FaceTree tree(level, level.world());
    for (int i = 0; i < 200; ++i) {
      const Ray ray{math::Vec3d(random.in_cube(120)), math::Vec3d(random.in_cube(1))};
      std::optional<double> nearest;
      for (const PolygonVertices& triangle : model.polygons)
        if (const auto distance = meet_triangle(ray, triangle); distance && *distance >= kNear)
          nearest = std::min(*distance, nearest.value_or(1e9));
      const auto hit = tree.nearest(ray, kNear, [](const FaceHit&) { return true; });
      ASSERT_EQ(hit.has_value(), nearest.has_value()) << "seed " << seed << " ray " << i;
      if (hit) {
        ASSERT_NEAR(hit->distance, *nearest, 1e-3 * *nearest) << "seed " << seed << " ray " << i;
      }
    }
  }
}

TEST(RayScene, PlacesBrushModels) {
  const std::array models = {PolygonModel{{square_facing_minus_x(100, 50)}},
                             PolygonModel{{square_facing_minus_x(10, 2)}}};
  const world::Level level = make_polygon_level(models);
  const PreparedLevel prepared(level);
  // A yaw of 90 degrees turns +x to +y: the square at x = 10 moves to y = 10, facing -y.
  const std::array instances = {
      render::BrushModelInstance{.model = world::ModelIndex{1}, .origin_world = {20, 0, 1}},
      render::BrushModelInstance{
          .model = world::ModelIndex{1}, .origin_world = {0, 30, 0}, .angles_deg = {0, 90, 0}}};
  const RayScene scene(prepared, instances);

  const auto moved = scene.nearest(ray_along_x(0, 2.5), kNear);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->instance, 1u);
  EXPECT_EQ(moved->face, world::FaceIndex{1});
  EXPECT_NEAR(moved->distance, 30, 1e-9);
  EXPECT_EQ(scene.nearest(ray_along_x(0, -1.5), kNear)->instance, 0u) << "below the moved square: the world";

  const auto turned = scene.nearest({{0, 0, 0}, {0, 1, 0}}, kNear);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->instance, 2u);
  EXPECT_NEAR(turned->distance, 40, 1e-9);
  EXPECT_NEAR(scene.distance_to_plane({{0, 0, 0}, {0, 1, 0}}, 2, world::FaceIndex{1}), 40, 1e-9);
  const math::Vec3d in_model = scene.to_model(2, {-1, 40, 2});
  EXPECT_NEAR(glm::distance(in_model, math::Vec3d(10, 1, 2)), 0, 1e-9);
}

}  // namespace
}  // namespace temblor::oracle
