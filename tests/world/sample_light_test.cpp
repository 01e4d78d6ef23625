// Compares the light below a point with a test of every face of the level.
#include "world/sample_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

// The point where the vertical line through `point` meets the face's plane, if it is inside of the face and
// below. A face that the line meets within `slack` of an edge counts neither as hit nor as missed.
struct Meeting {
  double z;
  bool near_edge;
};
std::optional<Meeting> meeting(const world::Level& level, const world::Face& face, const math::Vec3& point) {
  const world::Plane& plane = level.planes[face.plane];
  if (std::abs(plane.normal.z) < 1e-6f) return std::nullopt;
  const math::Vec3d n(plane.normal);
  const double z = (double{plane.distance} - n.x * double{point.x} - n.y * double{point.y}) / n.z;
  // Tests a point seen from above, by the even-odd rule.
  bool inside = false, near_edge = std::abs(z - double{point.z}) < 0.1;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3d a(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    const math::Vec3d b(
        level.vertices[level.surfedge_start(face.first_surfedge + (i + 1) % face.surfedge_count)]);
    const double px = point.x, py = point.y;
    if ((a.y > py) != (b.y > py) && px < (b.x - a.x) * (py - a.y) / (b.y - a.y) + a.x) inside = !inside;
    const math::Vec2d along(b.x - a.x, b.y - a.y), to(px - a.x, py - a.y);
    const double length2 = std::max(glm::dot(along, along), 1e-9);
    const double t = std::clamp(glm::dot(to, along) / length2, 0.0, 1.0);
    near_edge |= glm::distance(to, along * t) < 0.2;
  }
  if (!inside && !near_edge) return std::nullopt;
  return Meeting{z, near_edge};
}

struct Expected {
  bool clear = true;  // no edge is near the line
  const world::Face* face = nullptr;
  double z = -1e30;
};
Expected first_face_below(const world::Level& level, const math::Vec3& point) {
  Expected expected;
  const world::Model& model = level.world();
  for (std::uint32_t i = 0; i < model.face_count; ++i) {
    const world::Face& face = level.faces[model.first_face + i];
    if (face.kind != world::FaceKind::kLit) continue;
    const auto met = meeting(level, face, point);
    if (!met || met->z > point.z + 0.1 || met->z < point.z - 2048) continue;
    if (met->near_edge) expected.clear = false;
    if (met->z <= expected.z) continue;
    expected.z = met->z;
    expected.face = &face;
  }
  return expected;
}

// Bilinear interpolation with explicit weights.
double sum_face_light(const world::Level& level, const world::Face& face,
                      const world::LightStyleValues& styles, const math::Vec3d& p, std::size_t channels,
                      std::size_t channel) {
  if (face.light == world::kNoLight) return 0;
  const std::vector<std::uint8_t>& light = channels == 1 ? level.light : level.light_rgb;
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const int width = face.light_width(), height = face.light_height();
  const double s = (glm::dot(p, math::Vec3d(axes.s_axis)) + axes.s_offset - face.texture_mins[0]) / 16;
  const double t = (glm::dot(p, math::Vec3d(axes.t_axis)) + axes.t_offset - face.texture_mins[1]) / 16;
  double sum = 0;
  for (int style = 0; style < face.style_count; ++style)
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const double weight = std::max(0.0, 1 - std::abs(s - column)) * std::max(0.0, 1 - std::abs(t - row));
        const std::size_t sample =
            face.light + static_cast<std::size_t>((style * height + row) * width + column);
        sum += weight * light[sample * channels + channel] *
               styles[face.styles[static_cast<std::size_t>(style)]] / 256.0;
      }
  return sum;
}

void expect_light_of_first_face(const world::Level& level, int points) {
  world::LightStyleValues styles;
  for (std::size_t i = 0; i < styles.size(); ++i) styles[i] = static_cast<std::uint16_t>(40 + i * 37 % 500);
  const math::Bounds& bounds = level.world().bounds;
  int compared = 0;
  for (int seed = 0; seed < points; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    math::Vec3 point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float>(random.uniform(bounds.mins[axis], bounds.maxs[axis]));
    if (level.leaf(world::find_leaf(level, point)).contents != world::Contents::kEmpty) continue;
    const Expected expected = first_face_below(level, point);
    if (!expected.clear) continue;
    const world::PointLight light = world::sample_light(level, styles, point);
    if (expected.face == nullptr) {
      EXPECT_EQ(light, world::PointLight{}) << "seed " << seed;
      continue;
    }
    ++compared;
    const math::Vec3d at(point.x, point.y, expected.z);
    EXPECT_NEAR(light.gray, sum_face_light(level, *expected.face, styles, at, 1, 0), 0.02) << "seed " << seed;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double of_channel = level.light_rgb.empty()
                                    ? double{light.gray}
                                    : sum_face_light(level, *expected.face, styles, at, 3, channel);
      EXPECT_NEAR(light.rgb[static_cast<int>(channel)], of_channel, 0.02) << "seed " << seed;
    }
  }
  EXPECT_GT(compared, points / 100);
}

TEST(LightAt, IsThatOfTheFirstLitFaceBelow) {
  for (const artgen::SmallLevelOptions& options :
       {artgen::SmallLevelOptions{}, artgen::SmallLevelOptions{.four_styles = true},
        artgen::SmallLevelOptions{.colored_light = true}})
    expect_light_of_first_face(*small_level(options).level, effort(3000, 300));
}

TEST(LightAt, OfStockLevelsIsThatOfTheFirstLitFaceBelow) {
  DATA_FOLDER_OR_SKIP(data);
  expect_light_of_first_face(*stock_level(data, "start").level, effort(2000, 100));
  expect_light_of_first_face(*stock_level(data, "lq_e0m1").level, effort(2000, 100));
}

TEST(LightAt, OfALevelWithoutLightIsFull) {
  const DrawableLevel drawable = small_level({.light = false});
  const world::PointLight light =
      world::sample_light(*drawable.level, world::make_stored_light_styles(), math::Vec3(0.0f));
  EXPECT_EQ(light.gray, 255);
  EXPECT_EQ(light.rgb, math::Vec3(255.0f));
}

TEST(LightAt, FarAboveOrNowhereIsDark) {
  const DrawableLevel drawable = small_level();
  const float top = drawable.level->world().bounds.maxs.z;
  const math::Vec3 places[] = {
      {0, 0, top + 2050}, {1e6f, 0, 0}, {0, 0, -1e6f}, {std::nanf(""), 0, 0}, {0, 0, HUGE_VALF}};
  for (const math::Vec3& place : places)
    EXPECT_EQ(world::sample_light(*drawable.level, world::make_stored_light_styles(), place),
              world::PointLight{});
}

}  // namespace
}  // namespace temblor::test
