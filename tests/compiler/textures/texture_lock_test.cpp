#include "compiler/textures/texture_lock.h"

#include <gtest/gtest.h>

#include "compiler/textures/texture_axes.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::compiler {
namespace {

using formats::MapAlignment;
using math::Vec2d;
using math::Vec3d;

constexpr Vec2d kTextureSize(64, 128);

Vec3d random_vector(test::Random& random, double size) {
  return Vec3d(random.in_cube(size));
}

Vec3d compute_normal(const formats::MapSide& side) {
  const auto& p = side.points_world;
  return glm::normalize(glm::cross(p[0] - p[1], p[2] - p[1]));
}

formats::MapSide random_side(test::Random& random) {
  formats::MapSide side;
  // Sometimes along an axis, where the alignments have special cases.
  do {
    for (Vec3d& point : side.points_world) {
      point = random_vector(random, 256);
      if (random.chance(0.3)) point = glm::round(point / 128.0) * 128.0;
    }
    if (random.chance(0.3))
      for (Vec3d& point : side.points_world) point[static_cast<int>(random.below(2)) + 1] = 64;
  } while (!(glm::length(glm::cross(side.points_world[0] - side.points_world[1],
                                    side.points_world[2] - side.points_world[1])) > 2000));
  formats::MapTexturing& texturing = side.texturing;
  texturing.alignment = static_cast<MapAlignment>(random.below(3));
  texturing.offset = {random.uniform(-64, 64), random.uniform(-64, 64)};
  texturing.rotation_deg =
      random.chance(0.5) ? 90 * static_cast<double>(random.below(4)) : random.uniform(0, 360);
  texturing.scale = {random.log_uniform(0.25, 4), -random.log_uniform(0.25, 4)};
  texturing.s_axis = random_vector(random, 1);
  texturing.t_axis = random_vector(random, 1);
  for (auto& row : texturing.matrix)
    row = {random.uniform(-1, 1) / 32, random.uniform(-1, 1) / 32, random.uniform(-1, 1)};
  return side;
}

Placement random_placement(test::Random& random) {
  Placement placement;
  do {
    for (Vec3d& column : placement.columns) column = random_vector(random, 2);
  } while (std::abs(placement.determinant()) < 0.2);
  placement.offset = random_vector(random, 1000);
  return placement;
}

TEST(TextureLock, PointsKeepTheirTexels) {
  for (int seed = 0; seed < test::effort(5000, 500); ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(static_cast<std::uint64_t>(seed));
    const formats::MapSide before = random_side(random);
    const Placement placement = random_placement(random);
    const formats::MapSide after = place_side(before, placement);
    const TextureAxes axes_before = make_text_axes(before.texturing, compute_normal(before), kTextureSize);
    const TextureAxes axes_after = make_text_axes(after.texturing, compute_normal(after), kTextureSize);
    const auto& p = before.points_world;
    for (int i = 0; i < 4; ++i) {
      const Vec3d point =
          p[0] + (p[1] - p[0]) * random.uniform(-1, 1) + (p[2] - p[0]) * random.uniform(-1, 1);
      const Vec2d gap = axes_before.at(point) - axes_after.at(placement.apply(point));
      EXPECT_LT(glm::length(gap), 1e-6);  // texels
    }
  }
}

TEST(TextureLock, SidesKeepFacingOutward) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const formats::MapSide before = random_side(random);
    const Placement placement = random_placement(random);
    const formats::MapSide after = place_side(before, placement);
    const Vec3d behind = before.points_world[1] - compute_normal(before);
    EXPECT_LT(glm::dot(placement.apply(behind) - after.points_world[1], compute_normal(after)), 0)
        << "seed " << seed;
  }
}

TEST(TextureLock, SidesWithoutAPlaneKeepTheirAlignment) {
  formats::MapSide side;
  side.points_world = {Vec3d(1, 2, 3), Vec3d(1, 2, 3), Vec3d(4, 5, 6)};
  Placement placement;
  placement.offset = {10, 0, 0};
  const formats::MapSide after = place_side(side, placement);
  EXPECT_EQ(after.texturing, side.texturing);
  EXPECT_EQ(after.points_world[2], Vec3d(14, 5, 6));
}

TEST(TextureLock, CombinedPlacementsApplyOneAfterTheOther) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    const Placement outer = random_placement(random), inner = random_placement(random);
    const Vec3d point = random_vector(random, 100);
    EXPECT_LT(glm::length(combine(outer, inner).apply(point) - outer.apply(inner.apply(point))), 1e-9);
  }
}

}  // namespace
}  // namespace temblor::compiler
