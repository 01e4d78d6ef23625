// Portals: against points and lines in a level, and windows against the pixels that they stand for.
#include "lab/visible_faces/portals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "lab/registry.h"
#include "lab/visible_faces/leaf_portals.h"
#include "lab/visible_faces/portal_flood.h"
#include "lab/visible_faces/portal_window.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"
#include "world/visibility.h"

namespace temblor::lab {
namespace {

constexpr std::size_t kManyPortals = 1'000'000;

// Parts of a line, one for each leaf that it passes through.
struct LinePart {
  std::uint32_t leaf;
  math::Vec3d from, to;
};
void trace_line(const world::Level& level, world::Child child, const math::Vec3d& from, const math::Vec3d& to,
                std::vector<LinePart>& io_parts) {
  if (child.is_leaf()) {
    io_parts.push_back({static_cast<std::uint32_t>(child.leaf()), from, to});
    return;
  }
  const world::Node& node = level.node(child.node());
  const world::Plane& plane = level.planes[node.plane];
  const double from_height = world::distance_to(plane, from), to_height = world::distance_to(plane, to);
  const world::Child from_side = node.children[from_height >= 0 ? 0 : 1];
  const world::Child to_side = node.children[to_height >= 0 ? 0 : 1];
  if ((from_height >= 0) == (to_height >= 0)) return trace_line(level, from_side, from, to, io_parts);
  const math::Vec3d middle = from + (to - from) * (from_height / (from_height - to_height));
  trace_line(level, from_side, from, middle, io_parts);
  trace_line(level, to_side, middle, to, io_parts);
}

// Leaves 0.01 units thick count as passed beside them.
std::vector<LinePart> trace_open_line(const world::Level& level, const math::Vec3d& from,
                                      const math::Vec3d& to) {
  std::vector<LinePart> parts;
  trace_line(level, level.world().head, from, to, parts);
  std::erase_if(parts, [](const LinePart& part) { return glm::distance(part.from, part.to) < 0.01; });
  const auto solid = std::ranges::find_if(parts, [&](const LinePart& part) {
    return level.leaves[part.leaf].contents == world::Contents::kSolid;
  });
  parts.erase(solid, parts.end());
  return parts;
}

math::Vec3d any_direction(test::Random& io_random) {
  const double x = io_random.uniform(-1, 1);
  const double y = io_random.uniform(-1, 1);
  const double z = io_random.uniform(-0.5, 0.5);
  return glm::normalize(math::Vec3d(x, y, z));
}

void expect_portals_between_leaves(const world::Level& level) {
  const LevelPortals made = make_level_portals(level, kManyPortals).value();
  EXPECT_GT(made.portals.size(), 1u);
  std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
  for (const Portal& portal : made.portals) {
    joined.insert(std::minmax(portal.leaves[0], portal.leaves[1]));
    math::Vec3d middle(0.0);
    for (std::uint32_t i = 0; i < portal.corner_count; ++i) {
      const math::Vec3d& corner = made.corners[portal.first_corner + i];
      EXPECT_NEAR(glm::dot(portal.normal, corner) - portal.distance, 0, 1e-3);
      middle += corner / static_cast<double>(portal.corner_count);
    }
    for (const std::uint32_t leaf : portal.leaves)
      EXPECT_NE(level.leaves[leaf].contents, world::Contents::kSolid);
    // The middle of a narrow portal may be nearer to a third leaf than the step to each side.
    if (glm::distance(portal.mins, portal.maxs) < 1) continue;
    std::vector<LinePart> parts;
    trace_line(level, level.world().head, middle + portal.normal * 0.001, middle - portal.normal * 0.001,
               parts);
    EXPECT_TRUE(std::ranges::any_of(parts, [&](const auto& part) { return part.leaf == portal.leaves[0]; }));
    EXPECT_TRUE(std::ranges::any_of(parts, [&](const auto& part) { return part.leaf == portal.leaves[1]; }));
  }
  // No opening is missing: where a line goes from leaf to leaf, they have a portal.
  int crossed = 0;
  const int lines = test::effort(1000, 50);
  for (int seed = 0; seed < lines; ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const math::Vec3d eye(test::random_camera(level, random).origin_world);
    const auto parts = trace_open_line(level, eye, eye + any_direction(random) * 4000.0);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (glm::distance(parts[i - 1].to, parts[i].from) > 1e-6) continue;  // a thin leaf lies between them
      EXPECT_TRUE(joined.contains(std::minmax(parts[i - 1].leaf, parts[i].leaf))) << seed;
      ++crossed;
    }
  }
  EXPECT_GT(crossed, lines / 2);
}

TEST(LevelPortals, LieBetweenLeaves) {
  expect_portals_between_leaves(*test::small_level().level);
}

TEST(LevelPortals, LieBetweenLeavesOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e1m2"})
    expect_portals_between_leaves(*test::stock_level(data, name).level);
}

// Every leaf on a line of sight is reached, from eyes anywhere and in portals.
void expect_seen_leaves_are_reached(const world::Level& level, bool uses_octagons) {
  const LevelPortals portals = make_level_portals(level, kManyPortals).value();
  base::Arena arena;
  for (int seed = 0; seed < test::effort(100, 10); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    render::Scene scene{.level = &level, .camera = test::random_camera(level, random)};
    math::Vec3& eye = scene.camera.origin_world;
    if (seed % 2 == 1) {
      const Portal& portal = portals.portals[random.below(portals.portals.size())];
      eye = math::Vec3((portal.mins + portal.maxs) * 0.5);
    }
    const render::ViewFrame view = render::make_view_frame(scene, 320, 200);
    if (level.leaf(view.eye_leaf).contents == world::Contents::kSolid) continue;
    arena.reset();
    const FloodResult flood = flood_portals(portals, view, {.uses_octagons = uses_octagons}, arena);
    EXPECT_LE(flood.portals_clipped, 2 * portals.portals.size() * (kMaxLeafVisits + 1));
    for (int i = 0; i < 300; ++i) {
      const double x = static_cast<double>(random.below(320)) - view.center_x;
      const double y = view.center_y - static_cast<double>(random.below(200));
      const math::Vec3d ray =
          view.axes.forward + (view.axes.right * x + view.axes.up * y) / view.pixels_per_unit;
      for (const LinePart& part : trace_open_line(level, view.eye_world, view.eye_world + ray * 4000.0))
        ASSERT_TRUE(world::is_in_pvs(flood.leaves, world::LeafIndex{part.leaf})) << "seed " << seed;
    }
  }
}

TEST(PortalFlood, ReachesEveryLeafInSight) {
  for (const bool uses_octagons : {false, true})
    expect_seen_leaves_are_reached(*test::small_level().level, uses_octagons);
}

TEST(PortalFlood, ReachesEveryLeafInSightOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e1m2"})
    for (const bool uses_octagons : {false, true})
      expect_seen_leaves_are_reached(*test::stock_level(data, name).level, uses_octagons);
}

// Trees may use a plane twice. Then nothing is between the two nodes, and the leaf is on the side that the
// first one says.
TEST(PortalFlood, ReachesEveryLeafThatRepeatedPlanesDivide) {
  world::Level level = *test::small_level().level;
  level.identity = std::make_shared<const world::LevelIdentity>();
  const std::size_t count = level.nodes.size();
  for (std::size_t number = 0; number < count; ++number)
    for (std::size_t side = 0; side < 2; ++side) {
      const world::Child child = level.nodes[number].children[side];
      if (!child.is_leaf()) continue;
      world::Node repeated = level.nodes[number];
      repeated.face_count = 0;
      repeated.children[side] = child;
      repeated.children[1 - side] = {-1};  // leaf 0, which is solid
      level.nodes[number].children[side] = {static_cast<std::int32_t>(level.nodes.size())};
      level.nodes.push_back(repeated);
    }
  expect_seen_leaves_are_reached(level, false);
  EXPECT_EQ(make_level_portals(level, kManyPortals)->portals.size(),
            make_level_portals(*test::small_level().level, kManyPortals)->portals.size());
}

TEST(PortalFlood, EntersOnlyAllowedLeaves) {
  const world::Level& level = *test::small_level().level;
  const LevelPortals portals = make_level_portals(level, kManyPortals).value();
  test::Random random(3);
  const render::Scene scene{.level = &level, .camera = test::random_camera(level, random)};
  const render::ViewFrame view = render::make_view_frame(scene, 320, 200);
  base::Arena arena;
  EXPECT_GT(flood_portals(portals, view, {}, arena).leaves_reached, 1u);
  const std::vector<std::uint8_t> none(level.leaves.size());
  EXPECT_EQ(flood_portals(portals, view, {.enterable = none}, arena).leaves_reached, 1u);
}

TEST(PortalWindow, IsTightenedToThePixelsInIt) {
  constexpr int kSize = 12;
  for (int seed = 0; seed < test::effort(3000, 300); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    const auto any_interval = [&](int lowest, int highest) {
      const auto a = lowest + static_cast<int>(random.below(static_cast<std::size_t>(highest - lowest + 1)));
      const auto b = lowest + static_cast<int>(random.below(static_cast<std::size_t>(highest - lowest + 1)));
      return Interval{std::min(a, b), std::max(a, b)};
    };
    PortalWindow window = PortalWindow::whole(kSize, kSize);
    window.x = any_interval(0, kSize - 1);
    window.y = any_interval(0, kSize - 1);
    window.sum = any_interval(0, 2 * kSize - 2);
    window.difference = any_interval(1 - kSize, kSize - 1);
    PortalWindow tight = window;
    tight.tighten();
    int pixels = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const PortalWindow pixel{{x, x}, {y, y}, {x + y, x + y}, {x - y, x - y}};
        EXPECT_EQ(window.contains(pixel), tight.contains(pixel)) << seed;
        pixels += tight.contains(pixel);
      }
    EXPECT_TRUE(!tight.is_empty() || pixels == 0) << seed;
  }
}

TEST(Portals, RefuseALevelWithTooMany) {
  const world::Level& level = *test::small_level().level;
  const std::size_t count = make_level_portals(level, kManyPortals)->portals.size();
  EXPECT_TRUE(make_level_portals(level, count).ok());
  EXPECT_FALSE(make_level_portals(level, count - 1).ok());
  EXPECT_TRUE(parse_choice("portals").value().check_level(level).ok());
  const base::Status refused = parse_choice("portals:portals=3").value().check_level(level);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::kTooLarge);
  EXPECT_THAT(refused.error().what,
              testing::HasSubstr("small has more than 3 portals, so portals cannot draw it"));
  EXPECT_TRUE(parse_choice("painter").value().check_level(level).ok());
}

// Parallel planes, each behind the one before: all of them are cut at all others.
TEST(Portals, RefuseATreeThatIsTooDeep) {
  constexpr std::int32_t kDepth = 9000;
  world::Level level = *test::small_level().level;
  level.leaves.resize(2);
  level.leaves[1].contents = world::Contents::kEmpty;
  level.models[0].head = {0};
  level.planes.clear();
  level.nodes.clear();
  for (std::int32_t i = 0; i < kDepth; ++i) {
    constexpr world::Child kOpen{~1};
    level.planes.push_back({{1, 0, 0}, static_cast<float>(i), 0});
    world::Node node{};
    node.plane = static_cast<std::uint32_t>(i);
    node.children = {i + 1 < kDepth ? world::Child{i + 1} : kOpen, kOpen};
    level.nodes.push_back(node);
  }
  const base::Status refused = parse_choice("portals").value().check_level(level);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().what, "the BSP tree of level small is too deep, so portals cannot draw it");
}

}  // namespace
}  // namespace temblor::lab
