// Portal files: visibility from a level's own file is that of its portals, and files that do not fit are
// refused.
#include "compiler/portal_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/drafts.h"
#include "compiler/vis/visibility.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

// Three rooms in a row, a pool, and a detail pillar. The passages between the rooms are long and out of line,
// so the first and the last do not see each other.
std::string rooms_text() {
  std::string world = walls_text({0, 0, 0}, {768, 256, 128}, "wall");
  world += box_text({200, 0, 0}, {312, 224, 128}, "wall") + box_text({456, 32, 0}, {568, 256, 128}, "wall");
  world += box_text({0, 0, 0}, {200, 256, 24}, "*water");
  return entity_text("worldspawn", "", world) +
         entity_text("func_detail", "", box_text({360, 100, 0}, {400, 140, 128}, "pillar")) +
         point_text("info_player_start", {64, 64, 64});
}

compiler::BitMatrix search_visibility(const compiler::PortalSet& set) {
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  const compiler::SearchablePortals portals(set);
  compiler::VisibilityState state = compiler::begin_visibility(portals);
  compiler::continue_visibility(portals, jobs, compiler::kIgnoreProgress, state);
  return compiler::find_visible_clusters(portals, state);
}

class PortalFileOfRooms : public ::testing::Test {
 protected:
  compiler::Draft draft_ = compile_draft(rooms_text()).draft;
  formats::PortalFile file_ = compiler::make_portal_file(
      draft_.portals, static_cast<std::size_t>(draft_.bsp.models[0].visible_leaves));
};

TEST_F(PortalFileOfRooms, GivesTheSameVisibility) {
  EXPECT_LT(file_.cluster_count, file_.cluster_of_leaf.size()) << "detail splits a cluster";
  const auto read = formats::read_prt(formats::write_prt(file_));
  ASSERT_TRUE(read.ok()) << read.error().what;
  const auto portals = compiler::match_portal_file(*read, draft_.bsp);
  ASSERT_TRUE(portals.ok()) << portals.error().what;
  ASSERT_EQ(portals->cluster_of_leaf, draft_.portals.cluster_of_leaf);
  ASSERT_EQ(portals->portals.size(), draft_.portals.portals.size());
  const compiler::BitMatrix expected = search_visibility(draft_.portals), found = search_visibility(*portals);
  std::size_t hidden = 0;
  for (std::uint32_t from = 0; from < file_.cluster_count; ++from)
    for (std::uint32_t to = 0; to < file_.cluster_count; ++to) {
      EXPECT_EQ(found.at(from, to), expected.at(from, to)) << from << " " << to;
      hidden += found.at(from, to) ? 0 : 1;
    }
  EXPECT_GT(hidden, 0u);
}

// Tools differ in which side comes first.
TEST_F(PortalFileOfRooms, PortalsAreTurnedAsTheTreeSays) {
  for (formats::PrtPortal& portal : file_.portals) std::swap(portal.clusters[0], portal.clusters[1]);
  const auto turned = compiler::match_portal_file(file_, draft_.bsp);
  ASSERT_TRUE(turned.ok()) << turned.error().what;
  for (std::size_t i = 0; i < turned->portals.size(); ++i) {
    EXPECT_EQ(turned->portals[i].clusters, draft_.portals.portals[i].clusters) << i;
    EXPECT_NEAR(glm::distance(turned->portals[i].normal, draft_.portals.portals[i].normal), 0, 1e-6) << i;
    EXPECT_NEAR(turned->portals[i].distance, draft_.portals.portals[i].distance, 1e-3) << i;
  }
}

TEST_F(PortalFileOfRooms, FilesOfOtherLevelsAreRefused) {
  const auto problem = [&](const formats::PortalFile& file) {
    const auto portals = compiler::match_portal_file(file, draft_.bsp);
    return portals.ok() ? std::string("none") : portals.error().what;
  };
  formats::PortalFile other = file_;
  other.cluster_of_leaf.push_back(0);
  EXPECT_THAT(problem(other), HasSubstr("a level with"));
  other = file_;
  for (formats::PrtPortal& portal : other.portals)
    for (math::Vec3d& point : portal.points_world) point += math::Vec3d(3000, 0, 0);
  EXPECT_THAT(problem(other), HasSubstr("those of another level"));
  // Portals without an area are left out.
  other = file_;
  other.portals.push_back({{{8, 8, 8}, {8, 8, 8}, {8, 8, 8}}, {0, 1}});
  EXPECT_EQ(problem(other), "none");
}

}  // namespace
}  // namespace temblor::test
