// The space battle against rays: the nearest front of a face along the ray through each pixel, like a depth
// buffer without edges, spans, or a projection.
#include "lab/space_battle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "lab/space_battle/solid_edges.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using namespace lab::space;  // NOLINT: its names are the subject of every line here
using math::Vec2d;
using math::Vec3d;

constexpr std::uint32_t kBlack = 0xff000000;

// A face of a placed solid, in space.
struct PlacedFace {
  std::vector<Vec3d> corners;
  Vec3d normal{0.0};
  std::uint32_t color = 0;
};
struct PlacedSolid {
  Vec3d center{0.0};
  double radius = 0;
  std::vector<PlacedFace> faces;
};

PlacedSolid place(const Solid& solid, const Placement& placement, const formats::Rgb& color) {
  PlacedSolid placed{placement.center, solid.radius, {}};
  for (const SolidFace& face : solid.faces) {
    PlacedFace placed_face;
    for (const SolidSide& side : solid.list_sides(face))
      placed_face.corners.push_back(placement.center +
                                    turn_solid(placement.axes, solid.corners[side.corner]));
    placed_face.normal = turn_solid(placement.axes, face.normal);
    placed_face.color = light_face(color, placed_face.normal);
    placed.faces.push_back(std::move(placed_face));
  }
  return placed;
}

std::vector<PlacedSolid> place_all(const Battle& battle, double time_s) {
  std::vector<PlacedSolid> placed;
  for (const FormationSlot& slot : battle.formation().slots)
    placed.push_back(place(battle.solids()[slot.solid], find_placement(slot, time_s), slot.color));
  return placed;
}

// Whether a point of the face's plane is inside: an odd number of sides is on one side of it, along the two
// axes that the normal is farthest from.
bool contains(const PlacedFace& face, const Vec3d& point) {
  const Vec3d size = glm::abs(face.normal);
  const int dropped = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const auto flatten = [&](const Vec3d& p) { return Vec2d{p[(dropped + 1) % 3], p[(dropped + 2) % 3]}; };
  const Vec2d at = flatten(point);
  bool inside = false;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vec2d a = flatten(face.corners[i]), b = flatten(face.corners[(i + 1) % face.corners.size()]);
    if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

// The color of the nearest front at a place of the screen; black if there is none.
std::uint32_t cast_ray(const std::vector<PlacedSolid>& solids, const BattleView& view, double x, double y) {
  const Vec3d ray = view.axes.forward + view.axes.right * ((x - view.center_x) / view.pixels_per_unit) +
                    view.axes.up * ((view.center_y - y) / view.pixels_per_unit);
  double nearest = std::numeric_limits<double>::max();
  std::uint32_t color = kBlack;
  for (const PlacedSolid& solid : solids) {
    const Vec3d to_center = solid.center - view.eye;
    if (glm::length(glm::cross(to_center, ray)) > solid.radius * 1.001 * glm::length(ray)) continue;
    for (const PlacedFace& face : solid.faces) {
      const double toward = glm::dot(face.normal, ray);
      if (toward >= 0) continue;
      const double z = glm::dot(face.normal, face.corners[0] - view.eye) / toward;
      if (z < view.near_z || z >= nearest || !contains(face, view.eye + ray * z)) continue;
      nearest = z;
      color = face.color;
    }
  }
  return color;
}

struct Comparison {
  std::size_t solid_pixels = 0, ties = 0, wrong = 0;
};

// A pixel that differs is a tie if the ray finds its color within a ten-thousandth of a pixel.
Comparison compare_with_rays(const BattleOptions& options, const BattleView& view, double time_s) {
  std::vector<std::uint32_t> picture(static_cast<std::size_t>(view.width * view.height)), stars = picture;
  Battle battle(options);
  battle.draw(view, time_s, picture);
  Battle({.solids = 0, .seed = options.seed}).draw(view, time_s, stars);
  const std::vector<PlacedSolid> solids = place_all(battle, time_s);
  Comparison result;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y * view.width + x);
      const auto find = [&](double right, double down) {
        const std::uint32_t color = cast_ray(solids, view, x + right, y + down);
        return color == kBlack ? stars[pixel] : color;
      };
      const std::uint32_t expected = find(0, 0);
      result.solid_pixels += expected != stars[pixel];
      if (picture[pixel] == expected) continue;
      bool is_tie = false;
      for (const double right : {-1e-4, 0.0, 1e-4})
        for (const double down : {-1e-4, 0.0, 1e-4}) is_tie = is_tie || find(right, down) == picture[pixel];
      (is_tie ? result.ties : result.wrong) += 1;
    }
  return result;
}

BattleView look_from(const Vec3d& eye, const Vec3d& at, int width, int height) {
  math::Basis axes;
  axes.forward = glm::normalize(at - eye);
  axes.right = glm::normalize(glm::cross(axes.forward, Vec3d{0, 0, 1}));
  axes.up = glm::cross(axes.right, axes.forward);
  return make_battle_view(eye, axes, 90, width, height);
}

void expect_closed(const Solid& solid) {
  Vec3d sum(0.0);
  for (std::uint32_t number = 0; number < solid.faces.size(); ++number) {
    const SolidFace& face = solid.faces[number];
    const auto sides = solid.list_sides(face);
    Vec3d area(0.0);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Vec3d &a = solid.corners[sides[i].corner],
                  &b = solid.corners[sides[(i + 1) % sides.size()].corner];
      EXPECT_NEAR(glm::dot(face.normal, a), face.distance, 1e-12) << "the face is not flat";
      area -= glm::cross(a, b);
      EXPECT_NE(sides[i].neighbor, number);
    }
    EXPECT_GT(face.distance, 0) << "the face does not look away from the center";
    sum += area;
  }
  EXPECT_LT(glm::length(sum), 1e-12) << "the solid is open";
  EXPECT_LE(solid.radius, 1);
}

bool is_convex(const Solid& solid) {
  return std::ranges::all_of(solid.faces, [&](const SolidFace& face) {
    return std::ranges::all_of(solid.corners, [&](const Vec3d& corner) {
      return glm::dot(face.normal, corner) <= face.distance + 1e-12;
    });
  });
}

TEST(SpaceBattle, SolidsAreClosedAndConvexOrConcave) {
  for (const Solid& solid : make_convex_ships()) {
    expect_closed(solid);
    EXPECT_TRUE(is_convex(solid));
  }
  for (const Solid& solid : make_concave_ships()) {
    expect_closed(solid);
    EXPECT_FALSE(is_convex(solid));
  }
  expect_closed(make_shot());
}

TEST(SpaceBattle, SolidsNeverTouch) {
  for (const std::size_t count : {1, 2, 7, 100, 1000}) {
    const Battle battle({.solids = count, .shapes = BattleShapes::kBoth});
    ASSERT_EQ(battle.formation().slots.size(), count);
    for (const double time_s : {0.0, 3.7, 1234.5}) {
      const std::vector<PlacedSolid> solids = place_all(battle, time_s);
      for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < a; ++b)
          ASSERT_GT(glm::distance(solids[a].center, solids[b].center), solids[a].radius + solids[b].radius)
              << a << " and " << b << " of " << count << " at " << time_s;
    }
  }
}

TEST(SpaceBattle, PicturesAreThoseOfRays) {
  for (const BattleShapes shapes : {BattleShapes::kConvex, BattleShapes::kConcave, BattleShapes::kBoth})
    for (int seed = 1; seed <= effort(12, 2); ++seed) {
      const BattleOptions options{.solids = 100, .shapes = shapes, .seed = static_cast<std::uint64_t>(seed)};
      const Battle battle(options);
      const BattleView view =
          make_battle_view(battle.lookout(), battle.lookout_axes(), 70, effort(160, 80), effort(120, 60));
      const Comparison result = compare_with_rays(options, view, seed * 1.7);
      EXPECT_GT(result.solid_pixels, static_cast<std::size_t>(view.width * view.height / 50))
          << "seed " << seed;
      EXPECT_EQ(result.wrong, 0u) << "seed " << seed;
      EXPECT_LE(result.ties, 2u) << "seed " << seed;
    }
}

// The eye is among the solids, so that they are behind it, around it, and at the near plane.
TEST(SpaceBattle, SolidsAroundTheEyeAreClipped) {
  std::size_t clipped = 0;
  for (int seed = 1; seed <= effort(40, 4); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const BattleOptions options{
        .solids = 200, .shapes = BattleShapes::kBoth, .seed = static_cast<std::uint64_t>(seed)};
    const double time_s = random.uniform(0, 100);
    const std::size_t slot = random.below(200);
    const Vec3d center = find_placement(Battle(options).formation().slots[slot], time_s).center;
    const Vec3d away = Vec3d(random.in_cube(1));
    const Vec3d at = center + Vec3d(random.in_cube(1));
    BattleView view = look_from(center + away, at, 80, 60);
    view.near_z = random.log_uniform(0.01, 1);
    const Comparison result = compare_with_rays(options, view, time_s);
    EXPECT_EQ(result.wrong, 0u) << "seed " << seed;
    EXPECT_LE(result.ties, 2u) << "seed " << seed;
    clipped += glm::length(away) < 1 ? 1 : 0;
  }
  EXPECT_GT(clipped, 0u);
}

TEST(SpaceBattle, TenThousandSolids) {
  const BattleOptions options{.solids = kMaxSolids, .shapes = BattleShapes::kBoth};
  Battle battle(options);
  const BattleView view = make_battle_view(battle.lookout(), battle.lookout_axes(), 90, 96, 54);
  const Comparison result = compare_with_rays(options, view, 5);
  EXPECT_EQ(result.wrong, 0u);
  EXPECT_GT(battle.measure_depth_complexity(view, 5), 0.5);
}

// All types draw solids that do not touch. With one comparison for each pair, solids that intersect are drawn
// wrong.
TEST(SpaceBattle, IntersectingSolidsNeedMoreComparisons) {
  const auto compare = [](double spacing, DepthSorting sorting) {
    const BattleOptions options{
        .solids = 200, .shapes = BattleShapes::kBoth, .spacing = spacing, .sorting = sorting};
    const Battle battle(options);
    return compare_with_rays(options, make_battle_view(battle.lookout(), battle.lookout_axes(), 60, 160, 120),
                             1);
  };
  for (const DepthSorting sorting :
       {DepthSorting::kIndependent, DepthSorting::kAbutting, DepthSorting::kIntersecting})
    EXPECT_EQ(compare(kSafeSpacing, sorting).wrong, 0u) << static_cast<int>(sorting);
  EXPECT_GT(compare(0.7, DepthSorting::kIndependent).wrong, 20u);
  EXPECT_GT(compare(0.7, DepthSorting::kAbutting).wrong, 20u);
  EXPECT_EQ(compare(0.7, DepthSorting::kIntersecting).wrong, 0u);
}

TEST(SpaceBattle, AnEmptySceneIsStars) {
  Battle battle({.solids = 0});
  const BattleView view = make_battle_view(Vec3d(0.0), {}, 90, 160, 120);
  std::vector<std::uint32_t> picture(160 * 120);
  const BattleCounts counts = battle.draw(view, 0, picture);
  EXPECT_EQ(counts.edges, 0u);
  EXPECT_EQ(counts.spans, 120u);
  const auto dark = std::ranges::count(picture, kBlack);
  EXPECT_GT(dark, 160 * 120 / 2);
  EXPECT_LT(dark, 160 * 120 - 100);
}

// A star stays at its direction when the eye moves, and moves across the screen when it turns.
TEST(SpaceBattle, StarsTurnWithTheViewOnly) {
  Battle battle({.solids = 0});
  const auto draw = [&](const Vec3d& eye, const Vec3d& at) {
    std::vector<std::uint32_t> picture(64 * 48);
    battle.draw(look_from(eye, at, 64, 48), 0, picture);
    return picture;
  };
  const auto here = draw({0, 0, 0}, {1, 0.2, 0.1});
  EXPECT_EQ(here, draw({100, -50, 7}, {101, -49.8, 7.1}));
  EXPECT_NE(here, draw({0, 0, 0}, {1, 0.3, 0.1}));
}

TEST(SpaceBattle, SeedsDecideThePicture) {
  const auto draw = [](std::uint64_t seed, double time_s) {
    Battle battle({.solids = 100, .seed = seed});
    std::vector<std::uint32_t> picture(160 * 120);
    battle.draw(make_battle_view(battle.lookout(), battle.lookout_axes(), 90, 160, 120), time_s, picture);
    return picture;
  };
  EXPECT_EQ(draw(1, 2), draw(1, 2));
  EXPECT_NE(draw(1, 2), draw(2, 2));
  EXPECT_NE(draw(1, 2), draw(1, 2.5));
}

TEST(SpaceBattle, WarmFramesDoNotAllocate) {
  Battle battle({.solids = 1000, .shapes = BattleShapes::kBoth});
  const BattleView view = make_battle_view(battle.lookout(), battle.lookout_axes(), 90, 160, 120);
  std::vector<std::uint32_t> picture(160 * 120);
  for (int i = 0; i < 3; ++i) battle.draw(view, 1, picture);
  const std::uint64_t before = allocation_count();
  battle.draw(view, 1, picture);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace temblor::test
