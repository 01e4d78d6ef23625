#include "formats/levels/prt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/random.h"

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Prt, ReadsAllDialects) {
  const std::string portal = "4 0 1 (0 0 0 ) (0 64 0 ) (0 64 64.5 ) (0 0 64) \n";
  const auto plain = read_prt("PRT1\n2\n1\n" + portal);
  ASSERT_TRUE(plain.ok()) << plain.error().what;
  EXPECT_EQ(plain->cluster_count, 2u);
  EXPECT_THAT(plain->cluster_of_leaf, ElementsAre(0, 1));
  ASSERT_EQ(plain->portals.size(), 1u);
  EXPECT_THAT(plain->portals[0].clusters, ElementsAre(0, 1));
  EXPECT_EQ(plain->portals[0].points_world[2], math::Vec3d(0, 64, 64.5));

  const auto detail = read_prt("PRT2\r\n3\r\n2\r\n1\r\n" + portal + "2 0 -1\r\n1 -1\r\n");
  ASSERT_TRUE(detail.ok()) << detail.error().what;
  EXPECT_THAT(detail->cluster_of_leaf, ElementsAre(0, 1, 0));
  const auto merged = read_prt("PRT1-AM\n2\n1\n3\n" + portal + "0\n1\n0\n");
  ASSERT_TRUE(merged.ok()) << merged.error().what;
  EXPECT_EQ(*merged, *detail);
}

TEST(Prt, WritesWhatItReads) {
  EXPECT_EQ(write_prt({2, {0, 1}, {}}), "PRT1\n2\n0\n");
  EXPECT_EQ(write_prt({2, {1, 0, 1}, {{{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}, {1, 0}}}}),
            "PRT2\n3\n2\n1\n3 1 0 (0 0 0 ) (1 0 0 ) (0 0.5 0 ) \n1 -1\n0 2 -1\n");
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    PortalFile file;
    file.cluster_count = static_cast<std::uint32_t>(1 + random.below(9));
    file.cluster_of_leaf.resize(random.below(30));
    const auto some_cluster = [&] { return static_cast<std::uint32_t>(random.below(file.cluster_count)); };
    for (std::uint32_t& cluster : file.cluster_of_leaf) cluster = some_cluster();
    for (std::size_t count = random.below(20); count > 0; --count) {
      PrtPortal& portal = file.portals.emplace_back();
      portal.clusters = {some_cluster(), some_cluster()};
      for (std::size_t i = 0; i < 3 + random.below(5); ++i)
        portal.points_world.emplace_back(random.uniform(-9, 9), random.uniform(-4e3, 4e3),
                                         random.uniform(-1e-9, 1e6));
    }
    const auto again = read_prt(write_prt(file));
    ASSERT_TRUE(again.ok()) << seed << ": " << again.error().what;
    EXPECT_EQ(*again, file) << seed;
  }
}

TEST(Prt, FaultsAreErrorsWithLines) {
  struct Case {
    const char *text, *problem;
  };
  for (const Case& c : {
           Case{"", "\"\" is not the header"},
           Case{"PRT3\n1\n1\n", "\"PRT3\" is not the header"},
           Case{"PRT1\n-1\n0\n", "line 2: expected the number of leaves"},
           Case{"PRT1\n99999999\n0\n", "line 2: expected the number of leaves"},
           Case{"PRT1\n2\n999999999\n", "expected the number of portals"},
           Case{"PRT1\n2\n5\n", "expected a portal"},
           Case{"PRT1\n2\n1\n2 0 1 (0 0 0 ) (0 1 0 )\n", "line 4: expected a portal of 3 to 1024 points"},
           Case{"PRT1\n2\n1\n3 0 2 (0 0 0 ) (0 1 0 ) (1 1 1 )\n",
                "line 4: expected the number of a cluster, below 2"},
           Case{"PRT1\n2\n1\n3 0 1 (0 0 0 ) (0 1 nan ) (1 1 1 )\n", "line 4: expected a point"},
           Case{"PRT1\n2\n1\n3 0 1 (0 0 0 ) (0 1 0 )\n", "expected a point"},
           Case{"PRT2\n2\n1\n0\n0 -1\n", "only 1 of 2 leaves"},
           Case{"PRT2\n2\n2\n0\n0 1 -1\n", "expected a leaf of cluster 1"},
           Case{"PRT2\n2\n2\n0\n0 1 -1\n1 -1\n", "leaf 1 is in two clusters"},
           Case{"PRT2\n2\n2\n0\n0 2 -1\n1 -1\n", "expected a leaf of cluster 0, below 2"},
           Case{"PRT1-AM\n1\n0\n2\n0\n1\n", "expected the number of a cluster, below 1"},
       }) {
    const auto file = read_prt(c.text);
    ASSERT_FALSE(file.ok()) << c.text;
    EXPECT_THAT(file.error().what, HasSubstr(c.problem)) << c.text;
  }
}

// A text that ends early is an error, except after its last number.
TEST(Prt, CutOffTextsAreErrors) {
  const std::string whole = write_prt({2, {1, 0, 1}, {{{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}}, {1, 0}}}});
  for (std::size_t size = 0; size + 2 < whole.size(); ++size)
    EXPECT_FALSE(read_prt(whole.substr(0, size)).ok()) << size;
}

}  // namespace
}  // namespace temblor::formats
