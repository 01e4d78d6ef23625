// Leaf lookup is compared with a plain walk of the file's tree, the PVS with a plain decoder and with rays.
#include "world/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"
#include "world/naive_tree.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

math::Vec3 random_point(const TestLevel& test, test::Random& random) {
  const formats::BspModel& world = test.bsp.models[0];
  math::Vec3 point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(random.uniform(world.mins[axis] - 8, world.maxs[axis] + 8));
  return point;
}

math::Vec3 random_point_in(const formats::BspLeaf& leaf, test::Random& random) {
  math::Vec3 point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(random.uniform(leaf.mins[axis], leaf.maxs[axis]));
  return point;
}

void expect_leaves_of_points(const TestLevel& test, test::Random& random) {
  for (int i = 0; i < test::effort(5000, 500); ++i) {
    const math::Vec3 point = random_point(test, random);
    const std::size_t expected = naive_leaf(test.bsp, test.bsp.models[0].head_nodes[0], to_point(point));
    const LeafIndex leaf = find_leaf(*test.level, point);
    ASSERT_EQ(base::to_size(leaf), expected) << test.name;
    ASSERT_EQ(static_cast<std::int32_t>(point_contents(*test.level, point)),
              test.bsp.leaves[expected].contents);
    if (expected == 0) continue;
    const formats::BspLeaf& bsp_leaf = test.bsp.leaves[expected];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(point[axis], bsp_leaf.mins[axis] - 1) << test.name << " leaf " << expected;
      EXPECT_LE(point[axis], bsp_leaf.maxs[axis] + 1) << test.name << " leaf " << expected;
    }
  }
}

TEST(FindLeaf, IsTheLeafThatAPlainWalkFinds) {
  test::Random random(1);
  expect_leaves_of_points(small_test_level(), random);
  expect_leaves_of_points(small_test_level({.tiny = true}), random);
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) expect_leaves_of_points(test, random);
}

TEST(FindLeaf, PutsPointsOnAPlaneInFront) {
  const TestLevel test = small_test_level();
  int tested = 0;
  for (const Node& node : test.level->nodes) {
    if (!node.children[0].is_leaf()) continue;
    const Plane& plane = test.level->planes[node.plane];
    if (node.children[0].leaf() == LeafIndex{0}) continue;
    const Leaf& front = test.level->leaf(node.children[0].leaf());
    math::Vec3 point = (front.bounds.mins + front.bounds.maxs) / 2.0f;
    // Only where the leaf belongs to the world: find_leaf() does not walk the door's tree.
    if (find_leaf(*test.level, point) != node.children[0].leaf()) continue;
    point[plane.axis] = plane.distance;
    EXPECT_EQ(find_leaf(*test.level, point), node.children[0].leaf());
    ++tested;
  }
  EXPECT_GT(tested, 10);
}

// Row i of the file, one bool for each leaf, decoded byte by byte as the format says.
std::vector<bool> naive_row(const formats::Bsp& bsp, std::size_t leaf) {
  const auto count = static_cast<std::size_t>(bsp.models[0].visible_leaves);
  const std::int32_t offset = bsp.leaves[leaf].visibility_offset;
  if (leaf == 0 || offset < 0 || bsp.visibility.empty()) return std::vector<bool>(count, true);
  std::vector<bool> bits;
  std::size_t at = static_cast<std::size_t>(offset);
  while (bits.size() < count && at < bsp.visibility.size()) {
    const std::uint8_t byte = bsp.visibility[at++];
    int repeat = 1;
    if (byte == 0) repeat = at < bsp.visibility.size() ? bsp.visibility[at++] : 0;
    for (int i = 0; i < repeat * 8; ++i) bits.push_back((byte & (1 << (i % 8))) != 0);
  }
  bits.resize(count, false);
  return bits;
}

void expect_rows(const TestLevel& test) {
  std::vector<std::uint8_t> row;
  for (std::size_t leaf = 0; leaf < test.bsp.leaves.size(); ++leaf) {
    decompress_pvs(*test.level, base::to_index<LeafIndex>(leaf), row);
    const std::vector<bool> expected = naive_row(test.bsp, leaf);
    ASSERT_EQ(row.size(), (expected.size() + 7) / 8);
    for (std::size_t bit = 0; bit < row.size() * 8; ++bit) {
      const bool is_set = (row[bit / 8] >> (bit % 8) & 1) != 0;
      ASSERT_EQ(is_set, bit < expected.size() && expected[bit]) << test.name << " leaf " << leaf;
      ASSERT_EQ(is_in_pvs(row, base::to_index<LeafIndex>(bit + 1)), is_set);
    }
    EXPECT_FALSE(is_in_pvs(row, LeafIndex{0}));
    EXPECT_FALSE(is_in_pvs(row, base::to_index<LeafIndex>(row.size() * 8 + 1)));
  }
}

TEST(DecompressPvs, IsWhatAPlainDecoderReads) {
  expect_rows(small_test_level());
  expect_rows(small_test_level({.pvs = false}));
  DATA_FOLDER_OR_SKIP(base_folder);
  for (const TestLevel& test : stock_levels(base_folder)) expect_rows(test);
}

TEST(DecompressPvs, ReadsRowsOfAnyBytesWithinBounds) {
  test::Random random(2);
  formats::Bsp bsp = artgen::make_small_level();
  for (int round = 0; round < 20; ++round) {
    bsp.visibility.resize(1 + random.below(200));
    for (std::uint8_t& byte : bsp.visibility)
      byte = random.chance(0.4) ? 0 : static_cast<std::uint8_t>(random.bits());
    for (formats::BspLeaf& leaf : bsp.leaves)
      leaf.visibility_offset = static_cast<std::int32_t>(random.below(bsp.visibility.size()));
    bsp.models[0].visible_leaves = static_cast<std::int32_t>(random.below(bsp.leaves.size()));
    expect_rows(test_level("random rows", bsp));
  }
}

TEST(DecompressPvs, ReusesTheRowsMemory) {
  const TestLevel test = small_test_level();
  std::vector<std::uint8_t> row;
  decompress_pvs(*test.level, LeafIndex{1}, row);
  const std::uint8_t* memory = row.data();
  for (std::size_t leaf = 0; leaf < test.bsp.leaves.size(); ++leaf) {
    decompress_pvs(*test.level, base::to_index<LeafIndex>(leaf), row);
    EXPECT_EQ(row.data(), memory);
  }
}

// A line from an eye that has met only the eye's own contents proves that its leaves are visible. (Vis
// compilers end the view where the contents change, for example at a water surface.)
void expect_rays_stay_visible(const TestLevel& test, test::Random& random, int rays) {
  constexpr long double kGrazing = 0.1L;  // units: thinner pieces may be an artifact of rounded vertices
  const auto leaf_count = static_cast<std::size_t>(test.bsp.models[0].visible_leaves);
  std::vector<std::uint8_t> row;
  int proofs = 0;
  for (int i = 0; i < rays; ++i) {
    const std::size_t start_leaf = 1 + random.below(leaf_count);
    const math::Vec3 eye = random_point_in(test.bsp.leaves[start_leaf], random);
    const math::Vec3 target = random_point_in(test.bsp.leaves[1 + random.below(leaf_count)], random);
    const std::vector<LeafPiece> pieces = leaves_along(test.bsp, to_point(eye), to_point(target));
    const std::size_t eye_leaf = pieces.front().leaf;
    if (eye_leaf == 0) continue;
    decompress_pvs(*test.level, base::to_index<LeafIndex>(eye_leaf), row);
    for (const LeafPiece& piece : pieces) {
      if (test.bsp.leaves[piece.leaf].contents != test.bsp.leaves[eye_leaf].contents) break;
      if (piece.length < kGrazing) continue;
      EXPECT_TRUE(is_in_pvs(row, base::to_index<LeafIndex>(piece.leaf)))
          << test.name << " from leaf " << eye_leaf << " to leaf " << piece.leaf;
      if (piece.leaf != eye_leaf) ++proofs;
    }
  }
  EXPECT_GT(proofs, rays / 20) << test.name;
}

TEST(Pvs, HoldsEveryLeafThatARayReachesInTheSmallLevel) {
  test::Random random(3);
  expect_rays_stay_visible(small_test_level(), random, test::effort(50'000, 5000));
  expect_rays_stay_visible(small_test_level({.tiny = true}), random, 5000);
}

TEST(Pvs, HidesWhatLiesAroundTwoCorners) {
  const TestLevel test = small_test_level();
  const LeafIndex cellar = find_leaf(*test.level, {128, 960, 64});
  const LeafIndex court = find_leaf(*test.level, {1300, 600, 0});
  std::vector<std::uint8_t> row;
  decompress_pvs(*test.level, cellar, row);
  EXPECT_FALSE(is_in_pvs(row, court));
  decompress_pvs(*test.level, court, row);
  EXPECT_FALSE(is_in_pvs(row, cellar));
}

TEST(Pvs, HoldsEveryLeafThatARayReachesInStockLevels) {
  DATA_FOLDER_OR_SKIP(base_folder);
  test::Random random(4);
  for (const TestLevel& test : stock_levels(base_folder)) {
    if (test.bsp.visibility.empty()) continue;
    expect_rays_stay_visible(test, random, test::effort(5000, 1000));
  }
}

}  // namespace
}  // namespace temblor::world
