// Overdraw: the area of faces that our visibility lets through, compared with the finished level's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "compiler/bsp/tree_portals.h"
#include "compiler/compiled_maps.h"
#include "compiler/vis/sight_lines.h"
#include "compiler/vis/visibility.h"
#include "compiler/vis/visibility_lump.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/seen_area.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

using test::compute_face_areas;
using test::visible_area;

TEST(VisibilityTightness, LetsThroughNoMoreThanFinishedLevels) {
  DATA_FOLDER_OR_SKIP(folder);
  const std::vector<std::string> names =
      test::kQuick ? std::vector<std::string>{"start"}
                   : std::vector<std::string>{"start", "lq_e0m1", "lq_e1m2", "lqdm5"};
  for (const std::string& name : names) {
    const formats::Bsp theirs = finished_level(folder, name);
    const PortalSet portals = make_tree_portals(theirs, {.clusters = Clusters::kSharedVisibility}).value();
    base::Jobs jobs(2);
    VisibilityState state = begin_visibility(portals);
    continue_visibility(
        portals, jobs, [](std::size_t, std::size_t) { return true; }, state);
    formats::Bsp ours = theirs;
    ASSERT_TRUE(write_visibility(portals, find_visible_clusters(portals, state), {}, ours).ok());

    const auto our_level = world::make_level(ours, name).value();
    const auto their_level = world::make_level(theirs, name).value();
    const std::vector<double> areas = compute_face_areas(*our_level);
    test::Random random(1);
    double our_area = 0, their_area = 0;
    for (int i = 0; i < test::effort(1000, 30); ++i) {
      const auto point = random_open_point(theirs, random);
      ASSERT_TRUE(point);
      const auto leaf = base::to_index<world::LeafIndex>(leaf_at(theirs, *point));
      our_area += visible_area(*our_level, leaf, areas);
      their_area += visible_area(*their_level, leaf, areas);
    }
    ::testing::Test::RecordProperty(name, std::to_string(our_area / their_area));
    EXPECT_LE(our_area, 1.05 * their_area) << name;
    EXPECT_GT(our_area, 0.5 * their_area) << name << ": so little that something must be missing";
  }
}

// Leaves and faces are those of our own tree here, so only areas can be compared.
void expect_draws_no_more(const world::Level& ours, const formats::Bsp& finished, const std::string& name) {
  const auto theirs = world::make_level(finished, name).value();
  const std::vector<double> our_areas = compute_face_areas(ours), their_areas = compute_face_areas(*theirs);
  test::Random random(1);
  double our_area = 0, their_area = 0;
  for (int i = 0; i < test::effort(1000, 30); ++i) {
    const auto point = random_open_point(finished, random);
    ASSERT_TRUE(point);
    const math::Vec3 at(*point);
    our_area += visible_area(ours, world::find_leaf(ours, at), our_areas);
    their_area += visible_area(*theirs, world::find_leaf(*theirs, at), their_areas);
  }
  fmt::print("{:<8} area seen, ours / finished level's: {:.3f}\n", name, our_area / their_area);
  EXPECT_LE(our_area, 1.05 * their_area) << name;
  EXPECT_GT(our_area, 0.5 * their_area) << name << ": so little that something must be missing";
}

// Compares each leaf's row by the full search and by --fast, in the same tree (light does not change it).
void expect_within(const world::Level& narrow, const world::Level& wide, const std::string& name) {
  ASSERT_EQ(narrow.leaves.size(), wide.leaves.size());
  std::vector<std::uint8_t> seen, roughly_seen;
  std::size_t leaves_seen = 0, leaves_roughly_seen = 0;
  for (std::uint32_t i = 1; i <= narrow.visible_leaf_count; ++i) {
    world::decompress_pvs(narrow, world::LeafIndex{i}, seen);
    world::decompress_pvs(wide, world::LeafIndex{i}, roughly_seen);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      ASSERT_EQ(seen[k] & ~roughly_seen[k], 0) << name << ", leaf " << i << " sees more than by --fast";
      leaves_seen += static_cast<std::size_t>(std::popcount(seen[k]));
      leaves_roughly_seen += static_cast<std::size_t>(std::popcount(roughly_seen[k]));
    }
  }
  const bool has_rooms = name == "lq_e0m1";
  EXPECT_TRUE(!has_rooms || leaves_seen < leaves_roughly_seen) << name;
}

// One test, so that the full search, which takes most of the time, runs once for each map.
TEST(VisibilityTightness, CompiledLevelsDrawNoMoreThanFinishedOnesAndThanByFastVisibility) {
  DATA_FOLDER_OR_SKIP(folder);
  CompileOptions full, fast;
  full.light_policy = fast.light_policy = StagePolicy::kSkip;
  fast.fast_visibility = true;
  for (const std::string name : test::stock_maps()) {
    const auto ours = world::make_level(test::compile_stock_map(folder, name, full).level.bsp, name).value(),
               wide = world::make_level(test::compile_stock_map(folder, name, fast).level.bsp, name).value();
    expect_within(*ours, *wide, name);
    // Nothing is inside of an item box.
    if (!name.starts_with("b_")) expect_draws_no_more(*ours, finished_level(folder, name), name);
  }
}

}  // namespace
}  // namespace temblor::compiler
