// Mip levels: stock Quake's thresholds in cases computed by hand; the footprint rule against texture
// coordinates differentiated numerically; the nearest depth against points sampled all over the face.
#include "render/surfaces/choose_mip.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3d;
using render::Camera;
using render::ViewFrame;

struct StockCase {
  double nearest_z, axes_length;
  int mip;
};

// With 160 pixels per unit (320x240, 90 degrees), a texel of a wall with texture axes of length 1 is as wide
// as a pixel at 160 units, four tenths of a pixel at 400, and two tenths at 800. Shorter axes (larger texels)
// extend this: below 0.99, 0.49, and 0.32 the distances are two, three, and four times as large.
TEST(StockMip, FollowsTheOriginalsThresholds) {
  ViewFrame view;
  view.perspective = true;
  view.pixels_per_unit = 160;
  const StockCase cases[] = {
      {10, 1, 0},      {159, 1, 0},     {161, 1, 1},     {399, 1, 1},     {401, 1, 2},     {799, 1, 2},
      {801, 1, 3},     {9000, 1, 3},    {159, 2, 0},     {161, 2, 1},     {161, 0.99, 1},  {161, 0.98, 0},
      {319, 0.98, 0},  {321, 0.98, 1},  {799, 0.98, 1},  {801, 0.98, 2},  {1599, 0.98, 2}, {1601, 0.98, 3},
      {321, 0.49, 1},  {321, 0.48, 0},  {479, 0.48, 0},  {481, 0.48, 1},  {1199, 0.48, 1}, {1201, 0.48, 2},
      {2399, 0.48, 2}, {2401, 0.48, 3}, {481, 0.32, 1},  {481, 0.31, 0},  {639, 0.31, 0},  {641, 0.31, 1},
      {1599, 0.25, 1}, {1601, 0.25, 2}, {3199, 0.25, 2}, {3201, 0.25, 3},
  };
  for (const StockCase& stock : cases)
    EXPECT_EQ(render::stock_mip(view, 1 / stock.nearest_z, stock.axes_length, 0), stock.mip)
        << stock.nearest_z << " units away, axes of " << stock.axes_length;
}

// In parallel projection, distance does not matter.
TEST(StockMip, GoesByScaleInParallel) {
  ViewFrame view;
  view.perspective = false;
  for (const auto& [pixels_per_unit, mip] :
       {std::pair(2.0, 0), {1.01, 0}, {0.99, 1}, {0.41, 1}, {0.39, 2}, {0.21, 2}, {0.19, 3}}) {
    view.pixels_per_unit = pixels_per_unit;
    for (const double depth : {-1.0, -5000.0}) EXPECT_EQ(render::stock_mip(view, depth, 1, 0), mip);
  }
}

// Below mip 0, the finest level that is no wider than its pixels.
TEST(StockMip, GoesBelowZeroForFineTextures) {
  ViewFrame view;
  view.perspective = false;
  for (const auto& [pixels_per_unit, mip] : {std::pair(0.39, 2),
                                             {1.01, 0},
                                             {1.99, 0},
                                             {2.01, -1},
                                             {3.99, -1},
                                             {4.01, -2},
                                             {7.99, -2},
                                             {8.01, -3}}) {
    view.pixels_per_unit = pixels_per_unit;
    for (const int finest : {0, -1, -2, -3})
      EXPECT_EQ(render::stock_mip(view, 1, 1, finest), std::max(mip, finest)) << pixels_per_unit;
  }
}

class MipViews : public testing::Test {
 protected:
  ViewFrame any_view(Random& random) const {
    render::Scene scene;
    scene.level = level_.level.get();
    scene.camera.origin_world = random.in_cube(500);
    scene.camera.angles_deg = random.in_cube(180);
    scene.camera.fov_deg = static_cast<float>(random.uniform(30, 120));
    if (random.chance(0.4)) scene.camera.projection = render::Projection::kOrthographic;
    scene.camera.units_per_pixel = static_cast<float>(random.log_uniform(0.1, 10));
    return render::make_view_frame(scene, static_cast<int>(1 + random.below(1000)),
                                   static_cast<int>(1 + random.below(1000)));
  }
  const DrawableLevel level_ = small_level();
};

// A plane with its texture axes, and the texture coordinates of the point that a pixel shows.
struct TexturedPlane {
  Vec3d normal, s_axis, t_axis;
  double distance;

  std::optional<math::Vec2d> texels_at(const ViewFrame& view, double x, double y) const {
    const Vec3d aside =
        (view.axes.right * (x - view.center_x) - view.axes.up * (y - view.center_y)) / view.pixels_per_unit;
    const Vec3d origin = view.perspective ? view.eye_world : view.eye_world + aside;
    const Vec3d ray = view.perspective ? view.axes.forward + aside : view.axes.forward;
    const double along = glm::dot(normal, ray), z = (distance - glm::dot(normal, origin)) / along;
    if (std::abs(along) < 0.01 || z < 1) return std::nullopt;
    const Vec3d point = origin + ray * z;
    return math::Vec2d(glm::dot(s_axis, point), glm::dot(t_axis, point));
  }
};

TEST_F(MipViews, ShowOneTexelAPixelAsNearlyAsTheyCan) {
  int chosen[7] = {};
  for (int seed = 0; seed < effort(20000, 2000); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ViewFrame view = any_view(random);
    const double texels_per_unit = random.log_uniform(0.1, 10);
    const Vec3d normal = glm::normalize(Vec3d(random.in_cube(1)) + Vec3d(0, 0, 1e-3));
    const TexturedPlane plane{normal, Vec3d(random.in_cube(texels_per_unit)),
                              Vec3d(random.in_cube(texels_per_unit)), random.uniform(-500, 500)};
    const double x = random.uniform(0, view.width), y = random.uniform(0, view.height);
    constexpr double kStep = 1e-3;  // pixels
    const auto left = plane.texels_at(view, x - kStep, y), right = plane.texels_at(view, x + kStep, y);
    const auto above = plane.texels_at(view, x, y - kStep), below = plane.texels_at(view, x, y + kStep);
    if (!left || !right || !above || !below) continue;
    const math::Vec2d across = (*right - *left) / (2 * kStep), down = (*below - *above) / (2 * kStep);
    const double texels = std::abs(across.x * down.y - across.y * down.x);
    // Level k has 4^k times fewer texels. The best level is the one for which the ratio is nearest to 1.
    const double level = std::log2(texels) / 2;
    if (std::abs(level - std::floor(level) - 0.5) < 1e-3) continue;
    const int finest = -static_cast<int>(random.below(4));
    const int expected = static_cast<int>(std::clamp(std::round(level), static_cast<double>(finest), 3.0));

    render::TexturePlanes planes{render::depth_plane(view, plane.normal, plane.distance), {}, {}};
    planes.s = render::coordinate_plane(view, planes.depth, plane.s_axis, 5);
    planes.t = render::coordinate_plane(view, planes.depth, plane.t_axis, -7);
    ASSERT_EQ(render::footprint_mip(view, planes, x, y, finest), expected)
        << fmt::format("seed {}: {} texels a pixel", seed, texels);
    ++chosen[expected + 3];
  }
  for (const int count : chosen) EXPECT_GT(count, effort(300, 30));
}

// A triangle or a parallelogram around the line of sight, often partly outside the picture or behind the eye.
std::vector<Vec3d> random_polygon(const ViewFrame& view, Random& random) {
  const double size = random.log_uniform(1, 1000);
  const Vec3d middle = view.eye_world + view.axes.forward * random.uniform(-20, 500);
  const Vec3d a = middle + Vec3d(random.in_cube(size)), b = middle + Vec3d(random.in_cube(size));
  const Vec3d c = middle + Vec3d(random.in_cube(size));
  if (random.chance(0.5)) return {a, b, c};
  return {a, b, c, a + c - b};
}

TEST_F(MipViews, FindTheNearestDepthOnTheScreen) {
  int seen_count = 0;
  for (int seed = 0; seed < effort(1000, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const ViewFrame view = any_view(random);
    const std::vector<Vec3d> corners = random_polygon(view, random);
    // Samples: the nearest one in the picture, and the nearest one close to the picture.
    double on_screen = view.depth(1e9), about_screen = on_screen;
    constexpr int kSamples = 300;
    const Vec3d corner = view.to_view(corners[1]);
    const Vec3d side_0 = view.to_view(corners[0]) - corner, side_2 = view.to_view(corners[2]) - corner;
    for (int i = 0; i <= kSamples; ++i)
      for (int j = 0; j <= (corners.size() == 4 ? kSamples : kSamples - i); ++j) {
        const Vec3d in_view = corner + side_0 * (static_cast<double>(i) / kSamples) +
                              side_2 * (static_cast<double>(j) / kSamples);
        if (in_view.z < view.near_z || view.depth(in_view.z) <= on_screen) continue;
        const math::Vec2d screen = view.to_screen(in_view);
        const auto within = [&](double slack_x, double slack_y) {
          return screen.x >= -slack_x && screen.x <= view.width - 1 + slack_x && screen.y >= -slack_y &&
                 screen.y <= view.height - 1 + slack_y;
        };
        if (within(0, 0)) on_screen = std::max(on_screen, view.depth(in_view.z));
        if (within(2 + 0.1 * view.width, 2 + 0.1 * view.height))
          about_screen = std::max(about_screen, view.depth(in_view.z));
      }
    base::Arena arena;
    const double nearest = render::nearest_depth(view, corners, arena);
    ASSERT_GE(nearest, on_screen - 1e-9 * std::abs(on_screen)) << "seed " << seed;
    if (on_screen == view.depth(1e9)) continue;
    // A sample may miss the nearest point by one step along both sides.
    const double step =
        (glm::length(corners[0] - corners[1]) + glm::length(corners[2] - corners[1])) / kSamples;
    const double sampled_z = view.perspective ? 1 / about_screen : -about_screen;
    ASSERT_LE(nearest, view.depth(std::max(sampled_z - step, view.near_z)) * (1 + 1e-9) + 1e-9)
        << "seed " << seed;
    ++seen_count;
  }
  EXPECT_GT(seen_count, effort(200, 12));
}

}  // namespace
}  // namespace temblor::test
