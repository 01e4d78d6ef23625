// Cuts, hulls and separators of random polygons, checked with random points and lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/vis/flow/hull.h"
#include "compiler/vis/flow/separators.h"
#include "compiler/vis/flow/winding.h"
#include "support/random.h"

namespace temblor::compiler::vis {
namespace {

using math::Vec3d;

constexpr int kSeeds = 2000;

Vec3d random_unit(test::Random& random) {
  while (true) {
    const Vec3d vector(random.in_cube(1));
    if (glm::length(vector) > 0.1) return glm::normalize(vector);
  }
}

// Corners on an ellipse, clockwise seen from in front of the plane.
Winding random_polygon(const HalfSpace& plane, const Vec3d& near, test::Random& random) {
  const Vec3d right = glm::normalize(glm::cross(plane.normal, random_unit(random)));
  const Vec3d up = glm::cross(plane.normal, right);
  const Vec3d center = near - plane.normal * plane.above(near);
  const double width = random.log_uniform(1, 500), height = random.log_uniform(1, 500);
  Winding winding;
  winding.count = 3 + random.below(6);
  const double start = random.uniform(0, 1);
  for (std::size_t i = 0; i < winding.count; ++i) {
    const double angle =
        -2 * std::numbers::pi * (static_cast<double>(i) + start) / static_cast<double>(winding.count);
    winding.points[i] = center + right * (width * std::cos(angle)) + up * (height * std::sin(angle));
  }
  return winding;
}

HalfSpace random_plane(test::Random& random) {
  return {random_unit(random), random.uniform(-1000, 1000)};
}

Vec3d pick_random_point(const Winding& winding, test::Random& random) {
  Vec3d sum{0.0};
  double weights = 0;
  for (const Vec3d& corner : winding.corners()) {
    const double weight = random.uniform(0, 1);
    sum += corner * weight;
    weights += weight;
  }
  return sum / weights;
}

TEST(Windings, CutKeepsOnlyTheInside) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    test::Random random(seed);
    const HalfSpace plane = random_plane(random);
    const Winding whole = random_polygon(plane, Vec3d(random.in_cube(300)), random);
    HalfSpace keep{random_unit(random), 0};
    keep.distance = glm::dot(keep.normal, pick_random_point(whole, random));
    Winding left = whole;
    if (cut(left, keep) == Left::kNothing) left.count = 0;
    for (const Vec3d& corner : left.corners()) {
      EXPECT_GE(keep.above(corner), -kEpsilon * 1.001) << seed;
      EXPECT_NEAR(plane.above(corner), 0, 1e-6) << seed;
    }
    for (int i = 0; i < 20; ++i) {
      Winding point;
      point.count = 1;
      point.points[0] = pick_random_point(whole, random);
      if (keep.above(point.points[0]) > 3 * kEpsilon) {
        EXPECT_TRUE(left.count >= 3 && contains(left, point, plane.normal)) << seed;
      }
    }
  }
}

TEST(Windings, SeparatorsHideNothingThatALineReaches) {
  std::size_t with_planes = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    test::Random random(seed);
    const HalfSpace source_plane = random_plane(random), pass_plane = random_plane(random);
    Winding source = random_polygon(source_plane, Vec3d(random.in_cube(300)), random);
    Winding pass = random_polygon(pass_plane, Vec3d(random.in_cube(300)), random);
    if (cut(pass, source_plane) == Left::kNothing || cut(source, pass_plane.flipped()) == Left::kNothing)
      continue;
    Separators separators;
    find_separators({source, source_plane}, {pass, pass_plane}, separators);
    EXPECT_LE(separators.count, source.count + pass.count);
    with_planes += separators.count >= 3;
    for (int i = 0; i < 50; ++i) {
      const Vec3d from = pick_random_point(source, random), through = pick_random_point(pass, random);
      if (glm::length(through - from) < 1) continue;
      const double further = random.uniform(1, 10);
      const Vec3d arrives_at = from + (through - from) * further;
      for (const HalfSpace& plane : separators.all())
        ASSERT_GE(plane.above(arrives_at), -kEpsilon * 2 * further) << "seed " << seed;
    }
  }
  EXPECT_GT(with_planes, kSeeds / 8u);
}

TEST(Windings, FacingSquaresHaveFourCrossedSeparators) {
  // Squares with sides of 20 at x 0 and x 100: beyond, the view widens by 20 on each side for every 100
  // units.
  const HalfSpace source_plane{{1, 0, 0}, 0}, pass_plane{{1, 0, 0}, 100};
  Winding source, pass;
  source.count = pass.count = 4;
  source.points = {Vec3d(0, -10, -10), Vec3d(0, -10, 10), Vec3d(0, 10, 10), Vec3d(0, 10, -10)};
  for (std::size_t i = 0; i < 4; ++i) pass.points[i] = source.points[i] + Vec3d(100, 0, 0);
  Separators separators;
  find_separators({source, source_plane}, {pass, pass_plane}, separators);
  const auto hidden = [&](const Vec3d& point) {
    return std::ranges::any_of(separators.all(),
                               [&](const HalfSpace& plane) { return plane.above(point) < 0; });
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_FALSE(hidden({200, sign * 29.9, 0}));
    EXPECT_TRUE(hidden({200, sign * 30.1, 0}));
    EXPECT_FALSE(hidden({200, 0, sign * 29.9}));
    EXPECT_TRUE(hidden({200, 0, sign * 30.1}));
  }
}

TEST(Windings, HullContainsBothAndNoMore) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    test::Random random(seed);
    const HalfSpace plane = random_plane(random);
    const Winding a = random_polygon(plane, Vec3d(random.in_cube(300)), random);
    const Winding b = random_polygon(plane, Vec3d(random.in_cube(300)), random);
    Winding hull = a;
    ASSERT_TRUE(grow_hull(hull, b, plane.normal)) << seed;
    EXPECT_TRUE(contains(hull, a, plane.normal)) << seed;
    EXPECT_TRUE(contains(hull, b, plane.normal)) << seed;
    for (const Vec3d& corner : hull.corners())
      EXPECT_TRUE(std::ranges::count(a.corners(), corner) + std::ranges::count(b.corners(), corner) > 0)
          << seed;
  }
}

}  // namespace
}  // namespace temblor::compiler::vis
