// Portals of a tree compared with straight lines, which cross from leaf to leaf where a portal is.
#include "compiler/bsp/tree_portals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "compiler/drafts.h"
#include "compiler/vis/sight_lines.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/levels/small_bsp.h"

namespace temblor::compiler {
namespace {

using math::Vec3d;

// The distance by which a point is inside a clockwise winding, in its plane; negative outside.
double depth_inside(const Portal& portal, const Vec3d& point) {
  double depth = 1e9;
  const std::vector<Vec3d>& corners = portal.winding_world;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
    const Vec3d inward = glm::normalize(glm::cross(edge, portal.normal));
    depth = std::min(depth, glm::dot(inward, point - corners[i]));
  }
  return depth;
}

// The number of portals between two clusters that contain a point.
std::size_t portals_at(const PortalSet& set, std::uint32_t a, std::uint32_t b, const Vec3d& point) {
  return static_cast<std::size_t>(std::ranges::count_if(set.portals, [&](const Portal& portal) {
    const bool joins = (portal.clusters[0] == a && portal.clusters[1] == b) ||
                       (portal.clusters[0] == b && portal.clusters[1] == a);
    return joins && std::abs(glm::dot(portal.normal, point) - portal.distance) < 0.02 &&
           depth_inside(portal, point) > -0.05;
  }));
}

void expect_portals_where_lines_cross(const std::string& name, const formats::Bsp& bsp, int lines) {
  const PortalSet set = make_tree_portals(bsp).value();
  test::Random random(7);
  std::size_t crossings = 0;
  for (int i = 0; i < lines; ++i) {
    const auto along = leaves_along(bsp, random_point(bsp, random), random_point(bsp, random));
    for (std::size_t k = 1; k < along.size(); ++k) {
      const std::size_t from = along[k - 1].leaf, to = along[k].leaf;
      if (!can_see_through(bsp.leaves[from].contents, bsp.leaves[to].contents, true)) continue;
      ++crossings;
      ASSERT_GE(portals_at(set, set.cluster_of_leaf[from], set.cluster_of_leaf[to], along[k].enters_at), 1u)
          << name << ": from leaf " << from << " to " << to;
    }
  }
  EXPECT_GT(crossings, static_cast<std::size_t>(lines) / 4) << name;
}

// The leaves that a portal joins are a little to each side of its center.
void expect_portals_between_their_leaves(const std::string& name, const formats::Bsp& bsp) {
  const PortalSet set = make_tree_portals(bsp).value();
  ASSERT_FALSE(set.portals.empty());
  std::size_t wrong = 0;
  for (const Portal& portal : set.portals) {
    Vec3d middle{0.0};
    for (const Vec3d& corner : portal.winding_world) {
      EXPECT_NEAR(glm::dot(portal.normal, corner), portal.distance, 1e-6) << name;
      middle += corner / static_cast<double>(portal.winding_world.size());
    }
    EXPECT_GE(depth_inside(portal, middle), 0) << name << ": corners are clockwise";
    // Slivers are thinner than the tree's own rounding.
    if (depth_inside(portal, middle) < 0.1) continue;
    for (const std::size_t side : {0u, 1u}) {
      const Vec3d beside = middle + portal.normal * (side == 0 ? 0.05 : -0.05);
      wrong += set.cluster_of_leaf[leaf_at(bsp, beside)] != portal.clusters[side];
    }
  }
  // Some leaves are thinner than that distance.
  EXPECT_LE(wrong, set.portals.size() / 200) << name;
}

TEST(TreePortals, AreWhereLinesCrossFromLeafToLeaf) {
  expect_portals_where_lines_cross("small level", test::small_bsp(), 2000);
  DATA_FOLDER_OR_SKIP(folder);
  for (const char* name : {"start", "lq_e0m1"})
    expect_portals_where_lines_cross(name, finished_level(folder, name), test::effort(2000, 100));
}

TEST(TreePortals, JoinTheLeavesOnBothSides) {
  expect_portals_between_their_leaves("small level", test::small_bsp());
  DATA_FOLDER_OR_SKIP(folder);
  for (const char* name : {"start", "lq_e0m1", "lqdm5"})
    expect_portals_between_their_leaves(name, finished_level(folder, name));
}

TEST(TreePortals, NumberOpenLeavesAsClusters) {
  const formats::Bsp bsp = test::small_bsp();
  const PortalSet set = make_tree_portals(bsp).value();
  ASSERT_EQ(set.cluster_of_leaf.size(), bsp.leaves.size());
  EXPECT_EQ(set.cluster_of_leaf[0], kNoCluster);
  std::uint32_t next = 0;
  for (std::size_t leaf = 1; leaf <= static_cast<std::size_t>(bsp.models[0].visible_leaves); ++leaf)
    EXPECT_EQ(set.cluster_of_leaf[leaf], bsp.leaves[leaf].contents == -2 ? kNoCluster : next++);
  EXPECT_EQ(set.cluster_count, next);
}

std::size_t portals_at_surfaces(const formats::Bsp& bsp, bool see_through) {
  const PortalSet set = make_tree_portals(bsp, {.liquids_see_through = see_through}).value();
  std::vector<std::int32_t> contents(set.cluster_count);
  for (std::size_t leaf = 0; leaf < bsp.leaves.size(); ++leaf)
    if (set.cluster_of_leaf[leaf] != kNoCluster)
      contents[set.cluster_of_leaf[leaf]] = bsp.leaves[leaf].contents;
  return static_cast<std::size_t>(std::ranges::count_if(set.portals, [&](const Portal& portal) {
    return contents[portal.clusters[0]] != contents[portal.clusters[1]];
  }));
}

TEST(TreePortals, SeeThroughLiquidsOnlyOnRequest) {
  const std::string pool = test::box_text({-128, -128, 0}, {128, 128, 32}, "*water");
  const formats::Bsp bsp = test::compile_draft(test::room_text(pool)).draft.bsp;
  EXPECT_EQ(portals_at_surfaces(bsp, true), 1u);
  EXPECT_EQ(portals_at_surfaces(bsp, false), 0u);
}

TEST(TreePortals, SeeThroughTheRightContents) {
  constexpr std::int32_t kEmpty = -1, kSolid = -2, kWater = -3, kLava = -5, kSky = -6, kCurrent = -9;
  EXPECT_FALSE(can_see_through(kEmpty, kSolid, true));
  EXPECT_FALSE(can_see_through(kSolid, kWater, true));
  EXPECT_FALSE(can_see_through(kEmpty, kSky, true));
  EXPECT_FALSE(can_see_through(kSky, kWater, true));
  EXPECT_TRUE(can_see_through(kSky, kSky, false));
  EXPECT_TRUE(can_see_through(kEmpty, kLava, true));
  EXPECT_FALSE(can_see_through(kEmpty, kLava, false));
  EXPECT_TRUE(can_see_through(kWater, kCurrent, false));
}

TEST(TreePortals, JoinLeavesThatShareVisibilityOnRequest) {
  formats::Bsp bsp = test::small_bsp();
  for (std::size_t leaf = 1; leaf < bsp.leaves.size(); ++leaf) bsp.leaves[leaf].visibility_offset = 0;
  const PortalSet apart = make_tree_portals(bsp).value();
  const PortalSet shared = make_tree_portals(bsp, {.clusters = Clusters::kSharedVisibility}).value();
  // Sky is not a neighbor of what is below it.
  EXPECT_LT(shared.cluster_count, apart.cluster_count);
  for (const Portal& portal : apart.portals) {
    const auto cluster_after = [&](std::uint32_t cluster) {
      const auto leaf = std::ranges::find(apart.cluster_of_leaf, cluster) - apart.cluster_of_leaf.begin();
      return shared.cluster_of_leaf[static_cast<std::size_t>(leaf)];
    };
    EXPECT_EQ(cluster_after(portal.clusters[0]), cluster_after(portal.clusters[1]));
  }
  EXPECT_TRUE(shared.portals.empty());

  for (formats::BspLeaf& leaf : bsp.leaves) leaf.visibility_offset = -1;
  EXPECT_EQ(make_tree_portals(bsp, {.clusters = Clusters::kSharedVisibility})->cluster_count,
            apart.cluster_count);
}

}  // namespace
}  // namespace temblor::compiler
