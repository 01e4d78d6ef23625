// Rows and sounds as a level stores them, read back by the game's own reader and compared with finished
// levels.
#include "compiler/vis/visibility_lump.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "compiler/bsp/tree_portals.h"
#include "compiler/drafts.h"
#include "compiler/vis/sight_lines.h"
#include "compiler/vis/visibility.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/levels/small_bsp.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

formats::Bsp read_back(const formats::Bsp& bsp) {
  return std::move(formats::read_bsp(formats::write_bsp(bsp, bsp.version).value())).value();
}

// By leaf with a cluster: what the game reads from the level.
BitMatrix make_matrix(const formats::Bsp& bsp, const PortalSet& portals) {
  const auto level = world::make_level(bsp, "level").value();
  BitMatrix matrix(bsp.leaves.size(), bsp.leaves.size());
  std::vector<std::uint8_t> row;
  for (std::size_t from = 0; from < bsp.leaves.size(); ++from) {
    if (portals.cluster_of_leaf[from] == kNoCluster) continue;
    world::decompress_pvs(*level, base::to_index<world::LeafIndex>(from), row);
    for (std::size_t to = 0; to < bsp.leaves.size(); ++to)
      if (world::is_in_pvs(row, base::to_index<world::LeafIndex>(to))) matrix.set(from, to);
  }
  return matrix;
}

BitMatrix random_matrix(std::size_t size, test::Random& random) {
  BitMatrix matrix(size, size);
  const double density = random.uniform(0, 1) * random.uniform(0, 1);
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = 0; b < size; ++b)
      if (random.chance(density)) matrix.set(a, b);
  return matrix;
}

TEST(VisibilityLump, ReadsBackEqualToTheMatrix) {
  for (std::uint64_t seed = 0; seed < test::effort(20, 4); ++seed) {
    test::Random random(seed);
    formats::Bsp bsp = test::small_bsp({.tiny = seed % 2 == 0});
    const PortalSet portals = make_tree_portals(bsp).value();
    const BitMatrix visible = random_matrix(portals.cluster_count, random);
    ASSERT_TRUE(write_visibility(portals, visible, {}, bsp).ok());
    const BitMatrix read = make_matrix(read_back(bsp), portals);
    for (std::size_t a = 0; a < bsp.leaves.size(); ++a) {
      for (std::size_t b = 0; b < bsp.leaves.size(); ++b) {
        const std::uint32_t from = portals.cluster_of_leaf[a], to = portals.cluster_of_leaf[b];
        const bool expected = from != kNoCluster && to != kNoCluster && visible.at(from, to);
        ASSERT_EQ(read.at(a, b), expected) << "seed " << seed << ", leaf " << a << " to " << b;
      }
    }
  }
}

TEST(VisibilityLump, EqualRowsAreStoredOnce) {
  formats::Bsp bsp = test::small_bsp();
  const PortalSet portals = make_tree_portals(bsp).value();
  BitMatrix visible(portals.cluster_count, portals.cluster_count);
  for (std::size_t a = 0; a < visible.rows(); ++a) visible.set(a, a % 2);
  ASSERT_TRUE(write_visibility(portals, visible, {}, bsp).ok());
  std::set<std::int32_t> offsets;
  for (std::size_t leaf = 0; leaf < bsp.leaves.size(); ++leaf)
    if (portals.cluster_of_leaf[leaf] != kNoCluster) offsets.insert(bsp.leaves[leaf].visibility_offset);
  EXPECT_EQ(offsets.size(), 2u);
  EXPECT_EQ(bsp.leaves[0].visibility_offset, -1);
}

TEST(VisibilityLump, LongRunsOfZerosTakeTwoBytesPer255) {
  // 5,000 leaves that see only themselves: the row of leaf 4,097 by the format's definition.
  formats::Bsp bsp = test::small_bsp({.tiny = true});
  bsp.leaves.resize(5001, {.contents = -1});
  PortalSet portals;
  portals.cluster_count = 5000;
  portals.cluster_of_leaf.push_back(kNoCluster);
  BitMatrix visible(5000, 5000);
  for (std::uint32_t i = 0; i < 5000; ++i) {
    portals.cluster_of_leaf.push_back(i);
    visible.set(i, i);
  }
  ASSERT_TRUE(write_visibility(portals, visible, {}, bsp).ok());
  EXPECT_EQ(bsp.models[0].visible_leaves, 5000);
  // Bit 4096 is in byte 512 of 625: 255 + 255 + 2 zero bytes come before it, 112 after.
  const std::vector<std::uint8_t> expected{0, 255, 0, 255, 0, 2, 1, 0, 112};
  const auto start = bsp.visibility.begin() + bsp.leaves[4097].visibility_offset;
  EXPECT_EQ(std::vector<std::uint8_t>(start, start + 9), expected);
}

// Writing a finished level's own visibility again gives its own ambient levels.
TEST(VisibilityLump, SoundsMatchFinishedLevels) {
  DATA_FOLDER_OR_SKIP(folder);
  const std::vector<std::string> names =
      test::kQuick
          ? std::vector<std::string>{"start", "lqdm12"}
          : std::vector<std::string>{"start", "lqdm12", "lq_e0m1", "lq_e0m2", "lq_e0m9", "lqdm5", "start_e0"};
  for (const std::string& name : names) {
    const formats::Bsp theirs = finished_level(folder, name);
    const PortalSet portals = make_tree_portals(theirs).value();
    const BitMatrix by_leaf = make_matrix(theirs, portals);
    BitMatrix visible(portals.cluster_count, portals.cluster_count);
    for (std::size_t a = 0; a < theirs.leaves.size(); ++a)
      for (std::size_t b = 0; b < theirs.leaves.size(); ++b)
        if (by_leaf.at(a, b)) visible.set(portals.cluster_of_leaf[a], portals.cluster_of_leaf[b]);
    formats::Bsp ours = theirs;
    ASSERT_TRUE(write_visibility(portals, visible, {}, ours).ok());
    EXPECT_EQ(ours.models[0].visible_leaves, theirs.models[0].visible_leaves) << name;
    for (std::size_t leaf = 1; leaf < ours.leaves.size(); ++leaf)
      ASSERT_EQ(ours.leaves[leaf].ambient, theirs.leaves[leaf].ambient) << name << ", leaf " << leaf;
  }
}

TEST(VisibilityLump, UnwantedSoundsAreSilent) {
  // A single room, in which everything is visible.
  Draft draft =
      test::compile_draft(test::room_text(test::box_text({-128, -128, 0}, {-64, 128, 32}, "*water") +
                                          test::box_text({64, -128, 0}, {128, 128, 32}, "*lava") +
                                          test::box_text({-128, -128, 112}, {128, 128, 128}, "sky")))
          .draft;
  const std::uint32_t clusters = draft.portals.cluster_count;
  BitMatrix visible(clusters, clusters);
  for (std::uint32_t from = 0; from < clusters; ++from)
    for (std::uint32_t to = 0; to < clusters; ++to) visible.set(from, to);
  const auto sounds_with = [&](const AmbientSounds& sounds) {
    EXPECT_TRUE(write_visibility(draft.portals, visible, sounds, draft.bsp).ok());
    return draft.bsp.leaves[1].ambient;
  };
  EXPECT_EQ(sounds_with({}), (std::array<std::uint8_t, 4>{255, 255, 0, 255}));
  EXPECT_EQ(sounds_with({.water = false}), (std::array<std::uint8_t, 4>{0, 255, 0, 255}));
  EXPECT_EQ(sounds_with({.sky = false}), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
  EXPECT_EQ(sounds_with({.lava = false}), (std::array<std::uint8_t, 4>{255, 255, 0, 0}));
}

TEST(MeanVisibleShare, CountsLeavesNotClusters) {
  PortalSet portals;
  portals.cluster_count = 2;
  portals.cluster_of_leaf = {kNoCluster, 0, 0, 0, 1};
  BitMatrix visible(2, 2);
  visible.set(0, 0);
  visible.set(1, 1);
  EXPECT_DOUBLE_EQ(mean_visible_share(portals, visible), (9.0 + 1.0) / 16);
}

}  // namespace
}  // namespace temblor::compiler
