// The view: fields of view by their definition; the planes of depth and texture coordinates against the point
// where each pixel's ray meets the plane, computed with vectors.
#include "render/view/view_frame.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using math::Vec3d;
using render::Camera;
using render::Projection;
using render::ScreenPlane;
using render::ViewFrame;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

class ViewFrames : public testing::Test {
 protected:
  ViewFrame make_view(const Camera& camera, int width, int height) const {
    render::Scene scene;
    scene.level = level_.level.get();
    scene.camera = camera;
    return render::make_view_frame(scene, width, height);
  }
  ViewFrame make_fov_view(float fov_deg, int width, int height) const {
    return make_view({.fov_deg = fov_deg}, width, height);
  }
  ViewFrame any_view(Random& random) const {
    Camera camera;
    camera.origin_world = random.in_cube(2000);
    camera.angles_deg = random.in_cube(180);
    camera.fov_deg = static_cast<float>(random.uniform(10, 170));
    if (random.chance(0.4)) camera.projection = Projection::kOrthographic;
    if (random.chance(0.7)) camera.units_per_pixel = static_cast<float>(random.log_uniform(0.05, 20));
    return make_view(camera, static_cast<int>(1 + random.below(2000)),
                     static_cast<int>(1 + random.below(2000)));
  }
  const DrawableLevel level_ = small_level();
};

// The angle between the rays through the outer sides of the leftmost and the rightmost pixel.
double seen_across_deg(const ViewFrame& view) {
  return 2 * std::atan(view.width / 2.0 / view.pixels_per_unit) / radians(1);
}
double seen_down_deg(const ViewFrame& view) {
  return 2 * std::atan(view.height / 2.0 / view.pixels_per_unit) / radians(1);
}

TEST_F(ViewFrames, HaveTheFieldOfViewOfFourByThree) {
  for (const float fov_deg : {10.0f, 45.0f, 90.0f, 120.0f, 170.0f})
    EXPECT_NEAR(seen_across_deg(make_fov_view(fov_deg, 640, 480)), static_cast<double>(fov_deg), 1e-6);
  EXPECT_DOUBLE_EQ(make_fov_view(90, 320, 240).pixels_per_unit, 160);
}

TEST_F(ViewFrames, ShowMoreAtTheSidesWhereWider) {
  const double down_deg = seen_down_deg(make_fov_view(90, 640, 480));
  double across_deg = seen_across_deg(make_fov_view(90, 640, 480));
  for (const int width : {641, 768, 854, 1120, 4000}) {
    const ViewFrame view = make_fov_view(90, width, 480);
    EXPECT_NEAR(seen_down_deg(view), down_deg, 1e-9);
    EXPECT_GT(seen_across_deg(view), across_deg);
    across_deg = seen_across_deg(view);
  }
}

TEST_F(ViewFrames, ShowMoreAboveAndBelowWhereNarrower) {
  double down_deg = seen_down_deg(make_fov_view(90, 640, 480));
  for (const int height : {481, 512, 640, 1280, 4000}) {
    const ViewFrame view = make_fov_view(90, 640, height);
    EXPECT_NEAR(seen_across_deg(view), 90, 1e-9);
    EXPECT_GT(seen_down_deg(view), down_deg);
    down_deg = seen_down_deg(view);
  }
}

TEST_F(ViewFrames, KeepTheFieldOfViewWithin10And170) {
  EXPECT_DOUBLE_EQ(make_fov_view(1, 320, 240).pixels_per_unit, make_fov_view(10, 320, 240).pixels_per_unit);
  EXPECT_DOUBLE_EQ(make_fov_view(180, 320, 240).pixels_per_unit,
                   make_fov_view(170, 320, 240).pixels_per_unit);
}

TEST_F(ViewFrames, LookThroughTheMiddleOfThePicture) {
  for (const auto& [width, height] : {std::pair(320, 200), std::pair(1, 1), std::pair(333, 512)}) {
    const ViewFrame view = make_fov_view(90, width, height);
    // Pixel centers are at whole numbers, so the picture reaches from -0.5 to its size minus 0.5.
    const math::Vec2d middle = view.to_screen({0, 0, 100});
    EXPECT_DOUBLE_EQ(middle.x, (-0.5 + (width - 0.5)) / 2);
    EXPECT_DOUBLE_EQ(middle.y, (-0.5 + (height - 0.5)) / 2);
  }
}

TEST_F(ViewFrames, PutRightAndUpWhereTheyBelong) {
  // At angles 0 the view is along +x, left of it +y, up +z.
  const ViewFrame view = make_view({.origin_world = {100, 200, 300}}, 640, 480);
  const auto screen = [&](const Vec3d& world) { return view.to_screen(view.to_view(world)); };
  const math::Vec2d ahead = screen({200, 200, 300}), left = screen({200, 210, 300}),
                    above = screen({200, 200, 310});
  EXPECT_LT(left.x, ahead.x);
  EXPECT_DOUBLE_EQ(left.y, ahead.y);
  EXPECT_LT(above.y, ahead.y);
  EXPECT_DOUBLE_EQ(above.x, ahead.x);
  // A tenth as far to the side as ahead, at 320 pixels per unit.
  EXPECT_NEAR(ahead.x - left.x, 32, 1e-9);
  EXPECT_NEAR(ahead.y - above.y, 32, 1e-9);
}

TEST_F(ViewFrames, KnowTheLeafOfTheEye) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const math::Vec3 eye = random.in_cube(600);
    EXPECT_EQ(make_view({.origin_world = eye}, 64, 64).eye_leaf, world::find_leaf(*level_.level, eye));
  }
}

TEST_F(ViewFrames, DrawUnitsAtTheirScaleInParallel) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    Camera camera{.angles_deg = random.in_cube(180), .projection = Projection::kOrthographic};
    camera.units_per_pixel = static_cast<float>(random.log_uniform(0.1, 10));
    const ViewFrame view = make_view(camera, 320, 200);
    const Vec3d from(random.in_cube(1000)), along(random.in_cube(100));
    const math::Vec2d moved = view.to_screen(view.to_view(from + along)) - view.to_screen(view.to_view(from));
    // The component perpendicular to the view.
    const double across =
        std::sqrt(std::pow(glm::length(along), 2) - std::pow(glm::dot(along, view.axes.forward), 2));
    EXPECT_NEAR(glm::length(moved) * static_cast<double>(camera.units_per_pixel), across, 1e-4 * across);
  }
}

TEST_F(ViewFrames, FitTheLevelInParallelWhereNoScaleIsGiven) {
  const math::Bounds& bounds = level_.level->world().bounds;
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    Camera camera{.origin_world = (bounds.mins + bounds.maxs) * 0.5f,
                  .projection = Projection::kOrthographic};
    if (i > 0) camera.angles_deg = random.in_cube(180);
    const int width = static_cast<int>(1 + random.below(1000));
    const int height = static_cast<int>(1 + random.below(1000));
    const ViewFrame view = make_view(camera, width, height);
    double min_margin = 1;  // of the picture's width or height, on either side
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3d at(corner & 1 ? bounds.maxs.x : bounds.mins.x, corner & 2 ? bounds.maxs.y : bounds.mins.y,
                     corner & 4 ? bounds.maxs.z : bounds.mins.z);
      const math::Vec2d screen = view.to_screen(view.to_view(at));
      for (const double margin : {(screen.x + 0.5) / width, (width - 0.5 - screen.x) / width,
                                  (screen.y + 0.5) / height, (height - 0.5 - screen.y) / height})
        min_margin = std::min(min_margin, margin);
    }
    EXPECT_NEAR(min_margin, 0.025, 1e-6) << "the level fits with a margin of one twentieth";
  }
}

// A point is inside all five planes if it is in front of the near plane and within one pixel of the picture.
TEST_F(ViewFrames, AreBoundedByTheirFrustum) {
  int inside_count = 0;
  for (int seed = 0; seed < effort(20000, 2000); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ViewFrame view = any_view(random);
    const Vec3d point = view.eye_world + view.axes.forward * random.uniform(-100, 1000) +
                        view.axes.right * random.uniform(-1000, 1000) +
                        view.axes.up * random.uniform(-1000, 1000);
    const Vec3d in_view = view.to_view(point);
    bool inside = true;
    double nearest = 1e9;
    for (const render::FrustumPlane& plane : view.frustum) {
      const double distance = (glm::dot(plane.normal, point) + plane.offset) / glm::length(plane.normal);
      inside = inside && distance >= 0;
      nearest = std::min(nearest, std::abs(distance));
    }
    if (nearest < 1e-6) continue;
    bool expected = in_view.z >= view.near_z;
    if (expected) {
      const math::Vec2d screen = view.to_screen(in_view);
      expected = screen.x >= -1 && screen.x <= view.width && screen.y >= -1 && screen.y <= view.height;
    }
    ASSERT_EQ(inside, expected) << "seed " << seed;
    inside_count += inside;
  }
  EXPECT_GT(inside_count, effort(1000, 100));
}

// Where the ray of a pixel's center meets the plane normal . p = distance.
struct PlaneHit {
  Vec3d point;
  double depth;  // 1 / z, or -z in parallel
  bool steady;   // not along the plane, nor at the eye
};
PlaneHit hit_plane(const ViewFrame& view, const Vec3d& normal, double distance, double x, double y) {
  const double right = (x - view.center_x) / view.pixels_per_unit;
  const double up = -(y - view.center_y) / view.pixels_per_unit;
  const Vec3d aside = view.axes.right * right + view.axes.up * up;
  const Vec3d origin = view.perspective ? view.eye_world : view.eye_world + aside;
  const Vec3d ray = view.perspective ? view.axes.forward + aside : view.axes.forward;
  const double along = glm::dot(normal, ray);
  const double z = (distance - glm::dot(normal, origin)) / along;
  return {origin + ray * z, view.perspective ? 1 / z : -z, std::abs(along) > 0.01 && std::abs(z) > 0.1};
}

TEST_F(ViewFrames, MatchDirectEvaluationAtEveryPixel) {
  int checked = 0;
  for (int seed = 0; seed < effort(5000, 500); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ViewFrame view = any_view(random);
    const Vec3d normal = glm::normalize(Vec3d(random.in_cube(1)) + Vec3d(0, 0, 1e-3));
    const double distance = random.uniform(-1000, 1000);
    const Vec3d axis(random.in_cube(2));
    const double offset = random.uniform(-500, 500);
    const ScreenPlane depth = render::depth_plane(view, normal, distance);
    const ScreenPlane coordinate = render::coordinate_plane(view, depth, axis, offset);
    for (int pixel = 0; pixel < 10; ++pixel) {
      const double x = static_cast<double>(random.below(static_cast<std::size_t>(view.width)));
      const double y = static_cast<double>(random.below(static_cast<std::size_t>(view.height)));
      const PlaneHit hit = hit_plane(view, normal, distance, x, y);
      if (!hit.steady || std::abs(glm::dot(normal, view.eye_world) - distance) < 0.1) continue;
      ++checked;
      ASSERT_NEAR(depth.at(x, y), hit.depth, 1e-9 * std::max(1.0, std::abs(hit.depth))) << "seed " << seed;
      const double texel = glm::dot(axis, hit.point) + offset;
      const double expected = view.perspective ? texel * hit.depth : texel;
      const double size = std::abs(offset) + glm::length(hit.point) * glm::length(axis);
      ASSERT_NEAR(coordinate.at(x, y), expected, 1e-8 * std::max(1.0, size)) << "seed " << seed;
    }
  }
  EXPECT_GT(checked, effort(20000, 2000));
}

}  // namespace
}  // namespace temblor::test
