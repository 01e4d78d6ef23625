// Visibility compared with straight lines, with hand-made rooms and with finished levels.
#include "compiler/vis/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>

#include "compiler/bsp/tree_portals.h"
#include "compiler/vis/flow/base_visibility.h"
#include "compiler/vis/flow/flow_bounds.h"
#include "compiler/vis/flow/portal_flow.h"
#include "compiler/vis/flow/reach.h"
#include "compiler/vis/sight_lines.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/small_bsp.h"

namespace temblor::compiler {
namespace {

using math::Vec3d;

constexpr auto kKeepGoing = [](std::size_t, std::size_t) { return true; };

VisibilityState finished_state(const PortalSet& portals, int threads = 1) {
  base::Jobs jobs(threads, base::JobBackend::kStdThread);
  VisibilityState state = begin_visibility(portals);
  EXPECT_EQ(continue_visibility(portals, jobs, kKeepGoing, state), VisibilityEnd::kFinished);
  return state;
}

BitMatrix compute_visibility(const PortalSet& portals) {
  return find_visible_clusters(portals, finished_state(portals));
}

// A rectangle at x that faces +x, from (y0, z0) to (y1, z1); clockwise seen from +x.
Portal window_at_x(double x, double y0, double y1, double z0, double z1, std::uint32_t front,
                   std::uint32_t back) {
  return {{{x, y0, z0}, {x, y0, z1}, {x, y1, z1}, {x, y1, z0}}, {1, 0, 0}, x, {front, back}};
}

// Five cells in a row along x, each 100 units deep.
PortalSet row_of_cells(const std::array<std::array<double, 2>, 4>& windows_y) {
  PortalSet set;
  set.cluster_count = 5;
  for (std::uint32_t i = 0; i < 4; ++i)
    set.portals.push_back(window_at_x(100.0 * (i + 1), windows_y[i][0], windows_y[i][1], 0, 10, i + 1, i));
  return set;
}

TEST(Visibility, PassesAlignedWindows) {
  const BitMatrix visible = compute_visibility(row_of_cells({{{0, 10}, {0, 10}, {0, 10}, {0, 10}}}));
  for (std::size_t a = 0; a < 5; ++a)
    for (std::size_t b = 0; b < 5; ++b) EXPECT_TRUE(visible.at(a, b)) << a << " " << b;
}

TEST(Visibility, EndsWhereNoStraightLinePasses) {
  // Lines from the first cell through the first two windows are at y 50 at most at the third window, and the
  // last cell is behind a window that begins at 100.
  const BitMatrix visible = compute_visibility(row_of_cells({{{0, 10}, {20, 30}, {40, 60}, {100, 110}}}));
  EXPECT_TRUE(visible.at(0, 2));
  EXPECT_TRUE(visible.at(0, 3));
  EXPECT_FALSE(visible.at(0, 4));
  EXPECT_FALSE(visible.at(4, 0));
  EXPECT_FALSE(visible.at(1, 4));  // (30 + 30) < 100
  EXPECT_TRUE(visible.at(2, 4));
}

TEST(Visibility, IsExactToAHundredthOfAUnit) {
  // From y 0 through 10 at the second window, the steepest line is at 20 at the third window and at 30 at the
  // fourth.
  const auto last_seen = [](double from_y) {
    return compute_visibility(row_of_cells({{{0, 10}, {0, 10}, {0, 50}, {from_y, 60}}})).at(0, 4);
  };
  EXPECT_TRUE(last_seen(29.9));
  EXPECT_FALSE(last_seen(30.0));
}

TEST(Visibility, AClusterWithoutPortalsSeesItself) {
  PortalSet set;
  set.cluster_count = 70;
  const BitMatrix visible = compute_visibility(set);
  for (std::size_t a = 0; a < 70; ++a) EXPECT_EQ(count_bits(visible.row(a)), 1u) << a;
}

TEST(Visibility, PassesWindowsWithManyCorners) {
  // A round window with 60 corners; a small hole each is in line with its lowest and its highest piece.
  PortalSet set;
  set.cluster_count = 4;
  Portal round{{}, {1, 0, 0}, 100, {1, 0}};
  for (int i = 0; i < 60; ++i) {
    const double angle = -2 * 3.14159265358979 * i / 60;
    round.winding_world.push_back({100, 50 * std::cos(angle), 50 * std::sin(angle)});
  }
  set.portals = {round, window_at_x(200, -1, 1, 47, 49, 2, 1), window_at_x(200, -1, 1, -49, -47, 3, 1)};
  const BitMatrix visible = compute_visibility(set);
  EXPECT_TRUE(visible.at(0, 2));
  EXPECT_TRUE(visible.at(0, 3));
}

// Every leaf along a line between open points sees every other one, up to the first wall or sky.
void expect_lines_arrive(const std::string& name, const formats::Bsp& bsp, const PortalSet& portals,
                         const BitMatrix& visible, int lines) {
  test::Random random(11);
  std::size_t pairs = 0;
  for (int i = 0; i < lines; ++i) {
    const auto start = random_open_point(bsp, random);
    ASSERT_TRUE(start) << name;
    const math::Vec3d end = random_point(bsp, random);
    const auto along = leaves_along(bsp, *start, end);
    const auto first = portals.cluster_of_leaf[along[0].leaf];
    for (std::size_t k = 1; k < along.size(); ++k) {
      if (!can_see_through(bsp.leaves[along[k - 1].leaf].contents, bsp.leaves[along[k].leaf].contents, true))
        break;
      // Leaves are this thin where planes that should meet in a point do not.
      const math::Vec3d& leaves_at = k + 1 < along.size() ? along[k + 1].enters_at : end;
      if (glm::length(leaves_at - along[k].enters_at) < 0.1) continue;
      ++pairs;
      ASSERT_TRUE(visible.at(first, portals.cluster_of_leaf[along[k].leaf]))
          << name << ": line " << i << ", leaf " << along[0].leaf << " to " << along[k].leaf;
    }
  }
  EXPECT_GT(pairs, static_cast<std::size_t>(lines / 4)) << name;
}

TEST(Visibility, HidesNothingVisibleInASmallLevel) {
  const formats::Bsp bsp = test::small_bsp();
  const PortalSet portals = make_tree_portals(bsp).value();
  const int lines = test::effort(100'000, 3000);
  expect_lines_arrive("small level", bsp, portals, compute_visibility(portals), lines);
  base::Jobs jobs(1);
  expect_lines_arrive("small level, fast", bsp, portals, find_roughly_visible_clusters(portals, jobs), lines);
}

TEST(Visibility, HidesNothingVisibleInFinishedLevels) {
  DATA_FOLDER_OR_SKIP(folder);
  const std::vector<std::string> names =
      test::kQuick ? std::vector<std::string>{"lqdm12", "start"}
                   : std::vector<std::string>{"start", "lq_e0m1", "lq_e0m3", "lq_e1m2", "lqdm5", "lqdm11"};
  for (const std::string& name : names) {
    const formats::Bsp bsp = finished_level(folder, name);
    const PortalSet portals = make_tree_portals(bsp, {.clusters = Clusters::kSharedVisibility}).value();
    expect_lines_arrive(name, bsp, portals, compute_visibility(portals), test::effort(200'000, 3000));
  }
}

// The bound that ends long searches, used for every portal on its own.
TEST(Visibility, BoundOfLongSearchesHidesNothingVisible) {
  const formats::Bsp bsp = test::small_bsp();
  const PortalSet portals = make_tree_portals(bsp).value();
  const vis::PortalGraph graph = vis::make_portal_graph(portals);
  base::Jobs jobs(1);
  const vis::FlowBounds bounds(graph, vis::find_base_visibility(graph, jobs), true);
  vis::Reach reach(graph);
  BitMatrix bound(graph.portals.size(), graph.cluster_count),
      visible(graph.cluster_count, graph.cluster_count);
  std::size_t base_bits = 0, bound_bits = 0;
  for (std::uint32_t i = 0; i < graph.portals.size(); ++i) {
    reach.run(i, bounds, bounds.row(i), bound.row(i));
    base_bits += count_bits(bounds.row(i));
    bound_bits += count_bits(bound.row(i));
    visible.set(graph.portals[i].from, graph.portals[i].from);
    for (std::size_t word = 0; word < bound.row(i).size(); ++word)
      visible.row(graph.portals[i].from)[word] |= bound.row(i)[word];
  }
  EXPECT_LT(bound_bits, base_bits);
  expect_lines_arrive("small level, bound", bsp, portals, visible, test::effort(100'000, 3000));
}

// With few cuts, a search shows more than with many, never less, and stays within its bound.
TEST(Visibility, SearchesWithFewCutsHideNothingThatLongOnesShow) {
  const PortalSet portals = make_tree_portals(artgen::make_small_level()).value();
  const vis::PortalGraph graph = vis::make_portal_graph(portals);
  base::Jobs jobs(1);
  const vis::FlowBounds bounds(graph, vis::find_base_visibility(graph, jobs), true);
  vis::PortalFlow flow(graph);
  const std::atomic<bool> stop{false};
  std::size_t exact_bits = 0, rough_bits = 0;
  for (std::uint32_t i = 0; i < graph.portals.size(); ++i) {
    BitMatrix rows(2, graph.cluster_count);
    ASSERT_TRUE(flow.run(i, bounds, 0, stop, rows.row(0)));
    exact_bits += count_bits(rows.row(0));
    for (const std::size_t cuts : std::array<std::size_t, 4>{1, 5, 30, 300}) {
      std::ranges::fill(rows.row(1), BitMatrix::Word{0});
      ASSERT_TRUE(flow.run(i, bounds, cuts, stop, rows.row(1)));
      if (cuts == 1) rough_bits += count_bits(rows.row(1));
      for (std::size_t word = 0; word < rows.row(0).size(); ++word) {
        EXPECT_EQ(rows.row(0)[word] & ~rows.row(1)[word], 0u) << "portal " << i << ", cuts " << cuts;
        EXPECT_EQ(rows.row(1)[word] & ~bounds.row(i)[word], 0u) << "portal " << i << ", cuts " << cuts;
      }
    }
  }
  EXPECT_LT(exact_bits, rough_bits);
}

TEST(Visibility, IsSymmetricAndWithinTheRoughBound) {
  const PortalSet portals = make_tree_portals(test::small_bsp()).value();
  base::Jobs jobs(1);
  const BitMatrix visible = compute_visibility(portals), rough = find_roughly_visible_clusters(portals, jobs);
  for (std::size_t a = 0; a < visible.rows(); ++a) {
    for (std::size_t b = 0; b < visible.columns(); ++b) {
      EXPECT_EQ(visible.at(a, b), visible.at(b, a));
      EXPECT_TRUE(rough.at(a, b) || !visible.at(a, b));
    }
  }
}

TEST(Visibility, DoesNotDependOnThreads) {
  const PortalSet portals = make_tree_portals(test::small_bsp()).value();
  const VisibilityState one = finished_state(portals, 1);
  EXPECT_EQ(finished_state(portals, 2), one);
  EXPECT_EQ(finished_state(portals, 8), one);
  if (test::kQuick) return;
  DATA_FOLDER_OR_SKIP(folder);
  for (const std::string name : {"lq_e0m1", "lqdm5"}) {  // without and with crowded portals
    const PortalSet real =
        make_tree_portals(finished_level(folder, name), {.clusters = Clusters::kSharedVisibility}).value();
    const VisibilityState real_one = finished_state(real, 1);
    EXPECT_EQ(finished_state(real, 2), real_one) << name;
    EXPECT_EQ(finished_state(real, 8), real_one) << name;
  }
}

TEST(Visibility, ResumesToTheSameResult) {
  const PortalSet portals = make_tree_portals(test::small_bsp()).value();
  const VisibilityState whole = finished_state(portals);
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  VisibilityState state = begin_visibility(portals);
  int stops = 0;
  for (VisibilityEnd end = VisibilityEnd::kStopped; end == VisibilityEnd::kStopped; ++stops) {
    ASSERT_LT(stops, 10'000);
    int calls = 0;
    end = continue_visibility(
        portals, jobs, [&](std::size_t, std::size_t) { return ++calls < 20; }, state);
  }
  EXPECT_GT(stops, 3);
  EXPECT_EQ(state, whole);
}

TEST(Visibility, ProgressGrowsToItsTotal) {
  const PortalSet portals = make_tree_portals(test::small_bsp()).value();
  base::Jobs jobs(8, base::JobBackend::kStdThread);
  VisibilityState state = begin_visibility(portals);
  std::size_t last = 0, final_total = 0;
  continue_visibility(
      portals, jobs,
      [&](std::size_t done, std::size_t total) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, total);
        last = done;
        final_total = total;
        return true;
      },
      state);
  EXPECT_GT(final_total, 0u);
  EXPECT_EQ(last, final_total);
}

}  // namespace
}  // namespace temblor::compiler
