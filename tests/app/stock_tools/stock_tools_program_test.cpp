// Command lines of a mapper's build script, run with the built program.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/compile/compile_program.h"
#include "app/program.h"
#include "formats/levels/lit.h"
#include "formats/levels/prt.h"
#include "formats/levels/pts.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class StockTools : public CompileProgram {
 protected:
  ProgramRun run(const std::vector<std::string>& words) { return run_program(folder_.path(), words); }
  void expect_success(const std::vector<std::string>& words) {
    const ProgramRun done = run(words);
    EXPECT_EQ(done.exit_status, 0) << words[0] << ": " << done.err;
  }
  bool exists(const char* name) const { return fs::exists(folder_.path() / name); }
};

// Two rooms with a doorway between them, which see only parts of each other, and a detail pillar.
std::string two_rooms(const std::string& world_fields = {}) {
  const std::string world = walls_text({0, 0, 0}, {512, 256, 128}, "wall") +
                            box_text({248, 0, 0}, {264, 160, 128}, "wall") +
                            box_text({248, 224, 0}, {264, 256, 128}, "wall");
  return entity_text("worldspawn", world_fields, world) +
         entity_text("func_detail", "", box_text({100, 100, 0}, {120, 120, 128}, "pillar")) +
         point_text("info_player_start", {64, 64, 32}) + entity_text("light", "\"origin\" \"64 64 96\"");
}

// The script is one for the stock tools, which are links to Temblor.
TEST_F(StockTools, RunABuildScript) {
  folder_.write("rooms.map", two_rooms());
  expect_success({"compile", "rooms.map", "--extra", "2", "--clean", "-o", "whole.bsp"});
  const formats::Bsp whole = read_level("whole.bsp");
  fs::create_directory(folder_.path() / "tools");
  for (const char* tool : {"qbsp", "vis", "light"})
    fs::create_symlink(TEMBLOR_PROGRAM, folder_.path() / "tools" / tool);
  folder_.write("build.sh", std::string_view("set -e\n"
                                             "qbsp -nopercent -threads 2 rooms.map\n"
                                             "vis -level 4 rooms.bsp\n"
                                             "light -extra rooms\n"
                                             "qbsp -bsp2 rooms out\n"));
  const std::string folder = folder_.path().string();
  ASSERT_EQ(
      std::system(
          fmt::format("cd '{0}' && PATH='{0}/tools':\"$PATH\" sh build.sh > log.txt 2>&1", folder).c_str()),
      0)
      << read_text(folder_.path() / "log.txt");
  const auto portals = formats::read_prt(read_text(folder_.path() / "rooms.prt"));
  ASSERT_TRUE(portals.ok()) << portals.error().what;
  EXPECT_EQ(portals->cluster_of_leaf.size(), static_cast<std::size_t>(whole.models[0].visible_leaves));
  EXPECT_EQ(read_level("rooms.bsp"), whole) << "the stages of `temblor compile`";
  EXPECT_FALSE(exists("rooms.lit"));
  EXPECT_EQ(read_level("out.bsp").version, formats::BspVersion::kBsp2);
}

TEST_F(StockTools, HintsNameTheirOwnFlags) {
  folder_.write("rooms.map", two_rooms("\"wad\" \"missing.wad\""));
  EXPECT_THAT(run({"qbsp", "rooms.map"}).err, HasSubstr("(use -wadpath FOLDER to add a folder to search)"));
  EXPECT_THAT(run({"compile", "rooms.map"}).err, HasSubstr("(use --wad FOLDER to add a folder to search)"));
}

// Without the build file, portals come from the portal file; it is the only one that knows of detail.
TEST_F(StockTools, VisReadsThePortalFile) {
  folder_.write("rooms.map", two_rooms());
  expect_success({"qbsp", "rooms.map"});
  expect_success({"vis", "rooms.bsp"});
  const formats::Bsp expected = read_level("rooms.bsp");
  expect_success({"qbsp", "rooms.map", "again.bsp"});
  fs::remove(folder_.path() / "again.build");
  expect_success({"vis", "again.bsp"});
  EXPECT_EQ(read_level("again.bsp").visibility, expected.visibility);
  // A file of another level is not used, and the level still gets visibility.
  expect_success({"qbsp", "rooms.map", "other.bsp"});
  fs::remove(folder_.path() / "other.build");
  folder_.write("other.prt", std::string_view("PRT1\n1\n0\n"));
  const ProgramRun other = run({"vis", "other.bsp"});
  EXPECT_EQ(other.exit_status, 0);
  EXPECT_THAT(other.err, HasSubstr("other.prt: the portals are those of a level with 1 leaves"));
  EXPECT_FALSE(read_level("other.bsp").visibility.empty());
}

TEST_F(StockTools, LeavesThePathOfALeak) {
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  folder_.write("leak.map", entity_text("worldspawn", "", walls.substr(walls.find("}\n") + 2)) +
                                point_text("info_player_start", {0, 0, 32}));
  expect_success({"qbsp", "-leakdist", "8", "leak.map"});
  const auto points = formats::read_pts(read_text(folder_.path() / "leak.pts"));
  ASSERT_TRUE(points.ok());
  for (std::size_t i = 1; i < points->size(); ++i)
    EXPECT_LT(glm::distance((*points)[i - 1], (*points)[i]), 8.1f) << i;
  EXPECT_FALSE(exists("leak.prt"));
  const ProgramRun vis = run({"vis", "leak.bsp"});
  EXPECT_EQ(vis.exit_status, 0);
  EXPECT_THAT(vis.err, HasSubstr("leak.pts"));
  expect_success({"light", "leak.bsp"});
  EXPECT_TRUE(exists("leak.pts"));
  EXPECT_EQ(run({"qbsp", "-leaktest", "leak.map"}).exit_status, 1);
  // A sealed level has no path, but portals.
  folder_.write("leak.map", lit_room());
  expect_success({"qbsp", "leak.map"});
  EXPECT_FALSE(exists("leak.pts"));
  EXPECT_TRUE(exists("leak.prt"));
}

TEST_F(StockTools, FlagsOfLightOverrideTheLevelOnce) {
  folder_.write("rooms.map", two_rooms("\"_minlight\" \"5\""));
  expect_success({"qbsp", "rooms.map"});
  const auto darkest = [&] {
    const formats::Bsp level = read_level("rooms.bsp");
    return level.lighting.empty() ? 0 : int{*std::ranges::min_element(level.lighting)};
  };
  expect_success({"light", "rooms.bsp"});
  EXPECT_LT(darkest(), 10);
  expect_success({"light", "-minlight", "80", "-lit", "rooms.bsp"});
  EXPECT_GE(darkest(), 39);
  EXPECT_THAT(read_level("rooms.bsp").entities, HasSubstr("\"_minlight\" \"5\""));
  const auto lit = formats::read_lit(read_file(folder_.path() / "rooms.lit"));
  ASSERT_TRUE(lit.ok());
  EXPECT_EQ(lit->samples.size(), 3 * read_level("rooms.bsp").lighting.size());
  expect_success({"light", "rooms.bsp"});
  EXPECT_LT(darkest(), 10);
}

TEST_F(StockTools, LeaveOutDetailAndClipHulls) {
  folder_.write("rooms.map", two_rooms());
  const auto count_names = [&](const char* level) {
    const formats::Bsp bsp = read_level(level);
    return std::ranges::count(bsp.miptexes, "pillar", &formats::BspMiptex::name);
  };
  expect_success({"qbsp", "rooms.map", "all.bsp"});
  expect_success({"qbsp", "-omitdetail", "rooms.map", "bare.bsp"});
  expect_success({"qbsp", "-nodetail", "rooms.map", "solid.bsp"});
  EXPECT_EQ(count_names("all.bsp"), 1);
  EXPECT_EQ(count_names("bare.bsp"), 0);
  EXPECT_EQ(count_names("solid.bsp"), 1);
  EXPECT_THAT(read_text(folder_.path() / "all.prt"), ::testing::StartsWith("PRT2"));
  EXPECT_THAT(read_text(folder_.path() / "solid.prt"), ::testing::StartsWith("PRT1\n"));
  expect_success({"qbsp", "-noclip", "rooms.map", "air.bsp"});
  EXPECT_FALSE(read_level("all.bsp").clipnodes.empty());
  EXPECT_TRUE(read_level("air.bsp").clipnodes.empty());
}

TEST_F(StockTools, CompileWritesPortalsOnRequest) {
  folder_.write("rooms.map", two_rooms());
  expect_success({"compile", "rooms.map"});
  EXPECT_FALSE(exists("rooms.prt"));
  expect_success({"compile", "rooms.map", "--prt"});
  EXPECT_TRUE(exists("rooms.prt"));
}

}  // namespace
}  // namespace temblor::test
