// The files on disk while a level replaces another one.
#include "app/compile/level_output.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "app/program.h"
#include "support/levels/room_map.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;

// A room lit in one color. All have the same number of light samples, so the .lit of one would fit another.
std::string room(const char* color) {
  return entity_text("worldspawn", "", walls_text({-128, -128, 0}, {128, 128, 128}, "wall")) +
         point_text("info_player_start", {0, 0, 32}) +
         entity_text("light", std::string("\"origin\" \"64 64 96\"") + color);
}
const char* const kRed = "\n\"_color\" \"1 0.5 0.5\"";
const char* const kBlue = "\n\"_color\" \"0.5 0.5 1\"";
const char* const kWhite = "";

std::string text_or_none(const fs::path& file) {
  return fs::exists(file) ? read_text(file) : std::string();
}

// The bytes of a level and of its .lit.
using Pair = std::pair<std::string, std::string>;

class LevelOutput : public ::testing::Test {
 protected:
  ProgramRun compile() { return run_program(folder_.path(), {"compile", "room.map"}); }
  Pair compiled(const char* color) {
    folder_.write("room.map", room(color));
    EXPECT_EQ(compile().exit_status, 0);
    return on_disk();
  }
  Pair on_disk() const { return {text_or_none(paths_.bsp), text_or_none(paths_.lit)}; }

  // Returns every state that a killed run may leave while it replaces `before` with `after`.
  std::set<Pair> states_between(const char* before, const char* after) {
    compiled(after);
    const compiler::Build build = app::read_build_file(paths_);
    std::set<Pair> states;
    for (std::size_t cut = 0;; ++cut) {
      compiled(before);
      base::Result<app::PreparedLevel> level = app::prepare_level(build, std::nullopt, paths_);
      EXPECT_TRUE(level.ok());
      if (cut > level->steps.size()) return states;
      for (std::size_t i = 0; i < cut; ++i) EXPECT_TRUE(level->steps[i].commit().ok());
      states.insert(on_disk());
    }
  }
  bool has_new_files() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
      if (entry.path().extension() == ".new") return true;
    return false;
  }

  TemporaryFolder folder_;
  app::LevelPaths paths_ = app::make_level_paths(folder_.path() / "room.bsp");
};

TEST_F(LevelOutput, ColorsNeverBelongToAnotherLevel) {
  const Pair red = compiled(kRed), blue = compiled(kBlue), white = compiled(kWhite);
  ASSERT_EQ(red.second.size(), blue.second.size());
  ASSERT_NE(red.second, blue.second);
  ASSERT_EQ(white.second, "");
  const std::set<Pair> red_to_blue{red, {red.first, ""}, {blue.first, ""}, blue};
  EXPECT_EQ(states_between(kRed, kBlue), red_to_blue);
  const std::set<Pair> red_to_white{red, {red.first, ""}, white};
  EXPECT_EQ(states_between(kRed, kWhite), red_to_white);
  const std::set<Pair> white_to_blue{white, {blue.first, ""}, blue};
  EXPECT_EQ(states_between(kWhite, kBlue), white_to_blue);
  const std::set<Pair> as_it_was{blue};
  EXPECT_EQ(states_between(kBlue, kBlue), as_it_was) << "unchanged colors are not replaced";
  EXPECT_FALSE(has_new_files());
}

TEST_F(LevelOutput, KeepsTheLevelIfItsColorsCannotBeReplaced) {
  const Pair white = compiled(kWhite);
  fs::create_directories(paths_.lit / "in the way");
  folder_.write("room.map", room(kRed));
  EXPECT_EQ(compile().exit_status, 1);
  EXPECT_EQ(read_text(paths_.bsp), white.first);
  EXPECT_FALSE(has_new_files());
}

TEST_F(LevelOutput, KeepsLinksToColors) {
  compiled(kRed);
  fs::create_directory(folder_.path() / "elsewhere");
  fs::rename(paths_.lit, folder_.path() / "elsewhere/room.lit");
  fs::create_symlink("elsewhere/room.lit", paths_.lit);
  const std::string blue = compiled(kBlue).second;
  EXPECT_TRUE(fs::is_symlink(paths_.lit));
  EXPECT_EQ(read_text(folder_.path() / "elsewhere/room.lit"), blue);
}

}  // namespace
}  // namespace temblor::test
