// `temblor compile`, as a mapper uses it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "formats/bsp.h"
#include "support/game_data.h"
#include "support/room_map.h"
#include "support/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Words = std::vector<std::string>;

std::string lit_room() {
  return entity_text("worldspawn", "\"message\" \"A room\"",
                     walls_text({-128, -128, 0}, {128, 128, 128}, "wall")) +
         point_text("info_player_start", {0, 0, 32}) +
         entity_text("light", "\"origin\" \"64 64 96\"\n\"_color\" \"1 0.5 0.25\"");
}

class CompileProgram : public ::testing::Test {
 protected:
  formats::Bsp read_level(const std::string& name) {
    const base::ByteVector bytes = read_file(folder_.path() / name);
    return formats::read_bsp(bytes).value();
  }
  TemporaryFolder folder_;
};

TEST_F(CompileProgram, MapBecomesALevelThatIsDrawn) {
  folder_.write("room.map", lit_room());
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("texture")) << "the wall's texture is nowhere";
  EXPECT_THAT(run.out, HasSubstr("room.bsp"));
  const formats::Bsp bsp = read_level("room.bsp");
  EXPECT_EQ(bsp.version, formats::BspVersion::k29);
  EXPECT_THAT(bsp.lighting, Not(IsEmpty()));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "room.lit")) << "the light has a colour";
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.pts"));
  const ProgramRun inspected = run_program(folder_.path(), {"inspect", "--json", "room.bsp"});
  EXPECT_EQ(inspected.exit_status, 0) << inspected.err;
  EXPECT_THAT(nlohmann::json::parse(inspected.out).value("problems", nlohmann::json::array()), IsEmpty());
}

TEST_F(CompileProgram, SameInputGivesTheSameBytes) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "a.bsp", "--threads", "1"}).exit_status,
            0);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "b.bsp", "--threads", "3"}).exit_status,
            0);
  EXPECT_EQ(read_text(folder_.path() / "a.bsp"), read_text(folder_.path() / "b.bsp"));
  EXPECT_EQ(read_text(folder_.path() / "a.lit"), read_text(folder_.path() / "b.lit"));
}

TEST_F(CompileProgram, StagesCanBeLeftOut) {
  folder_.write("room.map", lit_room());
  const ProgramRun run = run_program(
      folder_.path(), {"compile", "room.map", "--no-light", "--no-vis", "--bsp2", "-o", "bare.bsp"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const formats::Bsp bsp = read_level("bare.bsp");
  EXPECT_EQ(bsp.version, formats::BspVersion::kBsp2);
  EXPECT_THAT(bsp.lighting, IsEmpty());
  EXPECT_THAT(bsp.visibility, IsEmpty());
}

TEST_F(CompileProgram, LeakIsToldAndItsWayIsWritten) {
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  folder_.write("leak.map", entity_text("worldspawn", "", walls.substr(walls.find("}\n") + 2)) +
                                point_text("info_player_start", {0, 0, 32}));
  const ProgramRun run = run_program(folder_.path(), {"compile", "leak.map"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.err, HasSubstr("info_player_start"));
  EXPECT_THAT(run.err, HasSubstr("leak.pts"));
  EXPECT_THAT(read_text(folder_.path() / "leak.pts"), HasSubstr("0.00 0.00 32.00\n"));
}

TEST_F(CompileProgram, WhatIsWrongIsOneLine) {
  folder_.write("broken.map", "{\n\"classname\" \"worldspawn\"\n{\n( 0 0 x )\n");
  folder_.write("empty.map", "");
  folder_.write("room.map", lit_room());
  struct Case {
    Words words;
    int status;
    std::vector<std::string> parts;
  };
  const std::vector<Case> cases = {
      {{"compile"}, 2, {"map"}},
      {{"compile", "none.map"}, 1, {"none.map"}},
      {{"compile", "broken.map"}, 1, {"broken.map", "line 4"}},
      {{"compile", "empty.map"}, 1, {"empty.map", "worldspawn"}},
      {{"compile", "room.map", "--wad", "none.wad"}, 1, {"none.wad", "--wad"}},
      {{"compile", "room.map", "--extra", "3"}, 2, {"--extra"}},
      {{"compile", "room.map", "-o", "nowhere/room.bsp"}, 1, {"nowhere/room.bsp", "-o"}},
  };
  for (const Case& c : cases) {
    const ProgramRun run = run_program(folder_.path(), c.words);
    EXPECT_EQ(run.exit_status, c.status) << run.err;
    std::string last = run.err;  // notes about textures may come before
    last.pop_back();
    last = last.substr(last.rfind('\n') + 1) + "\n";
    EXPECT_TRUE(is_one_error_line(last)) << run.err;
    for (const std::string& part : c.parts) EXPECT_THAT(last, HasSubstr(part));
  }
}

// A level that is there stays until the new one is whole.
TEST_F(CompileProgram, FailureLeavesTheOldLevel) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 0);
  const std::string before = read_text(folder_.path() / "room.bsp");
  folder_.write("room.map", lit_room() + "{");
  EXPECT_EQ(run_program(folder_.path(), {"compile", "room.map"}).exit_status, 1);
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), before);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.bsp.new"));
}

}  // namespace
}  // namespace temblor::test
