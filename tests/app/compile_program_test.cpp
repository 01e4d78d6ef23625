// `temblor compile`, as a mapper uses it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>
#include <utility>

#include "app/child_process.h"
#include "app/program.h"
#include "artgen/palette.h"
#include "formats/bsp.h"
#include "formats/png.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/room_map.h"
#include "support/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::ContainsRegex;
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
  const std::string world = entity_text("worldspawn", "", walls.substr(walls.find("}\n") + 2));
  folder_.write("leak.map", world + point_text("info_player_start", {0, 0, 32}));
  const ProgramRun run = run_program(folder_.path(), {"compile", "leak.map"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.err, HasSubstr(fmt::format("entity 1 (info_player_start) at 0 0 32, line {} of the map",
                                             1 + std::count(world.begin(), world.end(), '\n'))));
  EXPECT_THAT(run.err, HasSubstr("leak.pts"));
  EXPECT_THAT(read_text(folder_.path() / "leak.pts"), HasSubstr("0.00 0.00 32.00\n"));
  EXPECT_THAT(run.err, HasSubstr("leak.leak.png"));
  const Png picture = read_png(folder_.path() / "leak.leak.png");
  const auto has_pixel = [&](int red, int green, int blue) {
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
      if (picture.rgb[i] == red && picture.rgb[i + 1] == green && picture.rgb[i + 2] == blue) return true;
    return false;
  };
  EXPECT_TRUE(has_pixel(64, 230, 89)) << "where the way begins";
  EXPECT_TRUE(has_pixel(255, 51, 51)) << "where it ends";
  // Gone once the hole is mended.
  folder_.write("leak.map", lit_room());
  EXPECT_EQ(run_program(folder_.path(), {"compile", "leak.map"}).exit_status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "leak.pts"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "leak.leak.png"));
}

TEST_F(CompileProgram, KeepsWhatDidNotChange) {
  folder_.write("room.map", lit_room());
  const Words compile{"compile", "room.map"};
  ASSERT_EQ(run_program(folder_.path(), compile).exit_status, 0);
  const std::string level = read_text(folder_.path() / "room.bsp"),
                    lit = read_text(folder_.path() / "room.lit");
  const ProgramRun again = run_program(folder_.path(), compile);
  EXPECT_THAT(again.out, ContainsRegex("bsp +unchanged"));
  EXPECT_THAT(again.out, ContainsRegex("visibility +unchanged"));
  EXPECT_THAT(again.out, ContainsRegex("light +unchanged"));
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), level);
  EXPECT_EQ(read_text(folder_.path() / "room.lit"), lit);
  // Nothing is kept of what somebody else wrote, or of a file that is damaged.
  folder_.write("room.lit", std::string(lit.size(), 'x'));
  EXPECT_THAT(run_program(folder_.path(), compile).out, Not(HasSubstr("unchanged")));
  folder_.write("room.build", "no build file");
  const ProgramRun damaged = run_program(folder_.path(), compile);
  EXPECT_THAT(damaged.err, HasSubstr("room.build"));
  EXPECT_THAT(damaged.out, Not(HasSubstr("unchanged")));
  EXPECT_EQ(read_text(folder_.path() / "room.lit"), lit);
  EXPECT_THAT(run_program(folder_.path(), {"compile", "room.map", "--clean"}).out,
              Not(HasSubstr("unchanged")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.build"));
}

TEST_F(CompileProgram, OneStageAlone) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "whole.bsp"}).exit_status, 0);
  for (const char* stage : {"bsp", "vis", "light"}) {
    const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--only", stage});
    ASSERT_EQ(run.exit_status, 0) << run.err;
    const formats::Bsp bsp = read_level("room.bsp");
    EXPECT_EQ(bsp.visibility.empty(), std::string(stage) == "bsp");
    EXPECT_EQ(bsp.lighting.empty(), std::string(stage) != "light");
  }
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "whole.bsp"));
}

TEST_F(CompileProgram, LevelWithoutItsMapGetsVisibilityAndLight) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--clean"}).exit_status, 0);
  const formats::Bsp whole = read_level("room.bsp");
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--clean", "--only", "bsp", "-o", "bare.bsp"})
                .exit_status,
            0);
  const ProgramRun run = run_program(folder_.path(), {"compile", "bare.bsp", "-o", "again.bsp"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const formats::Bsp again = read_level("again.bsp");
  EXPECT_EQ(again.lighting, whole.lighting);
  EXPECT_EQ(again.visibility, whole.visibility);
  EXPECT_EQ(read_text(folder_.path() / "again.lit"), read_text(folder_.path() / "room.lit"));
}

TEST_F(CompileProgram, ShardsMakeTheSameLevel) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "whole.bsp"}).exit_status, 0);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--only", "bsp"}).exit_status, 0);
  const auto run = [&](const Words& words) {
    Words all{"compile", "room.map", "--only"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun done = run_program(folder_.path(), all);
    EXPECT_EQ(done.exit_status, 0) << done.err;
    return done;
  };
  constexpr int kMostRounds = 7;
  for (int round = 0; round < kMostRounds; ++round) {
    run({"vis", "--shard", "2/2"});
    run({"vis", "--shard", "1/2"});
    run({"vis", "--merge"});
  }
  EXPECT_THAT(run({"vis", "--merge"}).out, HasSubstr("visibility is finished"));
  for (const char* shard : {"1/3", "2/3", "3/3"}) run({"light", "--shard", shard});
  run({"light", "--merge"});
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "whole.bsp"));
  EXPECT_EQ(read_text(folder_.path() / "room.lit"), read_text(folder_.path() / "whole.lit"));
  for (const auto& file : std::filesystem::directory_iterator(folder_.path()))
    EXPECT_THAT(file.path().filename().string(), Not(HasSubstr("-of-")));
}

// Rows of pillars, each a little out of line: slow to work out what is seen between them.
std::string hall_of_pillars(int side) {
  const double width = side * 64;
  std::string brushes = walls_text({0, 0, 0}, {width, width, 128}, "wall");
  std::mt19937 random(1);
  const auto shift = [&] { return static_cast<double>(random() % 16); };
  for (int i = 0; i < side * side; ++i) {
    const math::Vec3d at(i % side * 64 + 16 + shift(), i / side * 64 + 16 + shift(), 0);
    brushes += box_text(at, at + math::Vec3d(16, 16, 128), "pillar");
  }
  return entity_text("worldspawn", "", brushes) + point_text("info_player_start", {8, 8, 40});
}

TEST_F(CompileProgram, MergeTakesFilesOfSharesAlone) {
  folder_.write("room.map", lit_room());
  const std::vector<std::string> others = {"room.light-copy",    "room.light-1-of-2.old", "room.light-0-of-2",
                                           "room.light-3-of-2",  "room.light-01-of-1",    "room.light-1-of-",
                                           "room.lights-1-of-1", "my.room.light-1-of-1"};
  for (const std::string& name : others) folder_.write(name, "no share of light");
  const ProgramRun none = run_program(folder_.path(), {"compile", "room.map", "--only", "light", "--merge"});
  EXPECT_EQ(none.exit_status, 1);
  EXPECT_THAT(none.err, HasSubstr("no shards to merge"));
  for (const Words& words : {Words{"--shard", "1/1"}, Words{"--merge"}}) {
    Words all{"compile", "room.map", "--only", "light"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun run = run_program(folder_.path(), all);
    EXPECT_EQ(run.exit_status, 0) << run.err;
  }
  for (const std::string& name : others)
    EXPECT_EQ(read_text(folder_.path() / name), "no share of light") << name;
}

// What is wrong is not the command line.
TEST_F(CompileProgram, SharesThatDoNotBelongTogetherAreAFaultOfTheirFiles) {
  folder_.write("room.map", lit_room());
  const auto run = [&](const char* stage, const Words& words) {
    Words all{"compile", "room.map", "--only", stage};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(folder_.path(), all);
  };
  for (const char* stage : {"vis", "light"}) ASSERT_EQ(run(stage, {"--shard", "1/2"}).exit_status, 0);
  const std::string more_light = entity_text("light", "\"origin\" \"0 0 64\"");
  for (const auto& [stage, map] :
       {std::pair{"vis", hall_of_pillars(2)}, {"light", lit_room() + more_light}}) {
    folder_.write("room.map", map);
    const ProgramRun merged = run(stage, {"--merge"});
    EXPECT_EQ(merged.exit_status, 1) << merged.err;
    EXPECT_THAT(merged.err, HasSubstr(fmt::format("room.{}-*", stage)));
    EXPECT_THAT(merged.err, Not(HasSubstr("--help")));
  }
}

TEST_F(CompileProgram, WatchCompilesWhatIsSaved) {
  folder_.write("room.map", lit_room());
  auto program = app::ChildProcess::start(
      {TEMBLOR_PROGRAM, "compile", (folder_.path() / "room.map").string(), "--watch", "--fast"});
  ASSERT_TRUE(program.ok()) << program.error().message();
  const auto wait_for = [&](const std::function<bool()>& is_so) {
    constexpr std::chrono::seconds kAtMost{60};
    const auto start = std::chrono::steady_clock::now();
    while (!is_so() && std::chrono::steady_clock::now() - start < kAtMost)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return is_so();
  };
  const auto has = [&](const char* text) {
    return std::filesystem::exists(folder_.path() / "room.bsp") &&
           read_level("room.bsp").entities.find(text) != std::string::npos;
  };
  ASSERT_TRUE(wait_for([&] { return has("A room"); }));
  folder_.write("room.map", lit_room() + "{");  // told, and not the end
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  folder_.write("room.map", lit_room() + point_text("monster_ogre", {50, 0, 30}));
  EXPECT_TRUE(wait_for([&] { return has("monster_ogre"); }));
}

TEST_F(CompileProgram, WatchMakesEverythingAnewWhenAsked) {
  folder_.write("room.map", lit_room());
  const std::string wait_for_runs =
      "for i in $(seq 300); do [ $(grep -c room.bsp: log) -ge {} ] && break; sleep 0.1; done; ";
  const std::string command = fmt::format("cd '{}' && ('{}' compile room.map --watch --clean >log 2>&1 & ",
                                          folder_.path().string(), TEMBLOR_PROGRAM) +
                              fmt::format(fmt::runtime(wait_for_runs), 1) + "touch room.map; " +
                              fmt::format(fmt::runtime(wait_for_runs), 2) + "kill $!)";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string log = read_text(folder_.path() / "log");
  EXPECT_THAT(log, ContainsRegex("room.bsp:.*\n(.*\n)*room.bsp:")) << "two runs";
  EXPECT_THAT(log, Not(HasSubstr("unchanged")));
}

TEST_F(CompileProgram, StoppedVisibilityGoesOn) {
  folder_.write("hall.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "hall.map"}).exit_status, 0);
  const std::string old_level = read_text(folder_.path() / "hall.bsp");
  folder_.write("hall.map", hall_of_pillars(effort(14, 10)));
  const std::string map = (folder_.path() / "hall.map").string();
  const auto exists = [&](const char* name) { return std::filesystem::exists(folder_.path() / name); };
  // Stopped before visibility begins nothing is saved: then later.
  for (int wait_ms = 100; wait_ms < 10'000 && !exists("hall.visibility"); wait_ms += wait_ms / 2) {
    auto program =
        app::ChildProcess::start({TEMBLOR_PROGRAM, "compile", map, "--no-light", "--threads", "1"});
    ASSERT_TRUE(program.ok()) << program.error().message();
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
  }
  ASSERT_TRUE(exists("hall.visibility"));
  ASSERT_EQ(read_text(folder_.path() / "hall.bsp"), old_level)
      << "it was finished before it could be stopped";
  // The old level has lost nothing.
  folder_.write("room.map", lit_room());
  const ProgramRun back = run_program(folder_.path(), {"compile", "room.map", "-o", "hall.bsp"});
  EXPECT_THAT(back.out, ContainsRegex("light +unchanged"));
  ASSERT_TRUE(exists("hall.visibility"));
  ASSERT_EQ(run_program(folder_.path(), {"compile", "hall.map", "--no-light"}).exit_status, 0);
  EXPECT_FALSE(exists("hall.visibility"));
  ASSERT_EQ(run_program(folder_.path(), {"compile", "hall.map", "--no-light", "--clean", "-o", "whole.bsp"})
                .exit_status,
            0);
  EXPECT_EQ(read_text(folder_.path() / "hall.bsp"), read_text(folder_.path() / "whole.bsp"));
}

TEST_F(CompileProgram, WatchEndsWhenVisibilityIsStopped) {
  folder_.write("hall.map", hall_of_pillars(effort(14, 10)));
  const std::string map = (folder_.path() / "hall.map").string();
  const auto exists = [&](const char* name) { return std::filesystem::exists(folder_.path() / name); };
  for (int wait_ms = 100; wait_ms < 10'000 && !exists("hall.visibility"); wait_ms += wait_ms / 2) {
    auto program = app::ChildProcess::start(
        {TEMBLOR_PROGRAM, "compile", map, "--watch", "--no-light", "--threads", "1"});
    ASSERT_TRUE(program.ok()) << program.error().message();
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
  }  // its destructor waits for the end
  EXPECT_TRUE(exists("hall.visibility"));
  EXPECT_FALSE(exists("hall.bsp")) << "it was finished before it could be stopped";
}

// The script in docs/, with processes in place of machines.
TEST_F(CompileProgram, ScriptForGnuParallelMakesTheSameLevel) {
  if (std::system("command -v parallel >/dev/null") != 0) GTEST_SKIP() << "GNU parallel is not installed";
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "whole.bsp"}).exit_status, 0);
  std::filesystem::create_directory(folder_.path() / "my programs");
  std::filesystem::create_symlink(TEMBLOR_PROGRAM, folder_.path() / "my programs/temblor 1");
  for (const char* program :
       {TEMBLOR_PROGRAM, "./my programs/temblor 1", TEMBLOR_PROGRAM " --set r_mip_rule=stock"}) {
    const std::string command =
        fmt::format("cd '{}' && TEMBLOR='{}' '{}/compile_with_parallel.sh' 2 room.map >log 2>&1",
                    folder_.path().string(), program, TEMBLOR_DOCS);
    ASSERT_EQ(std::system(command.c_str()), 0) << program << read_text(folder_.path() / "log");
    EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "whole.bsp"));
    EXPECT_EQ(read_text(folder_.path() / "room.lit"), read_text(folder_.path() / "whole.lit"));
    for (const char* file : {"room.bsp", "room.lit", "room.build"})
      std::filesystem::remove(folder_.path() / file);
  }
}

TEST_F(CompileProgram, WhatIsWrongIsOneLine) {
  folder_.write("broken.map", "{\n\"classname\" \"worldspawn\"\n{\n( 0 0 x )\n");
  folder_.write("empty.map", "");
  folder_.write("broken.bsp", "no level");
  folder_.write("room.map", lit_room());
  struct Case {
    Words words;
    int status;
    std::vector<std::string> parts;
  };
  const std::vector<Case> cases = {
      {{"compile"}, 2, {"map"}},
      {{"compile", "--textures", "."}, 2, {"map", ".wad"}},
      {{"compile", "--textures", ".", "-o", "art.wad"}, 1, {"--textures", ".png"}},
      {{"compile", "none.map"}, 1, {"none.map"}},
      {{"compile", "broken.map"}, 1, {"broken.map", "line 4"}},
      {{"compile", "empty.map"}, 1, {"empty.map", "worldspawn"}},
      {{"compile", "room.map", "--wad", "none.wad"}, 1, {"none.wad", "--wad"}},
      {{"compile", "room.map", "--extra", "3"}, 2, {"--extra"}},
      {{"compile", "room.map", "-o", "nowhere/room.bsp"}, 1, {"nowhere/room.bsp", "-o"}},
      {{"compile", "room.map", "--only", "qbsp"}, 2, {"qbsp", "bsp, vis and light"}},
      {{"compile", "room.map", "--only", "vis", "--no-light"}, 2, {"--only", "--no-light"}},
      {{"compile", "room.map", "--shard", "1/2"}, 2, {"--only"}},
      {{"compile", "room.map", "--only", "bsp", "--merge"}, 2, {"--merge"}},
      {{"compile", "room.map", "--only", "vis", "--shard", "0/2"}, 2, {"0/2"}},
      {{"compile", "room.map", "--only", "vis", "--shard", "3/2"}, 2, {"3/2"}},
      {{"compile", "room.map", "--only", "light", "--merge"}, 1, {"room.light", "--shard"}},
      {{"compile", "none.bsp"}, 1, {"none.bsp"}},
      {{"compile", "broken.bsp"}, 1, {"broken.bsp"}},
      {{"compile", "none.bsp", "--watch"}, 2, {"--watch"}},
      {{"compile", "none.bsp", "--bsp2"}, 2, {"--bsp2", ".map"}},
      {{"compile", "none.bsp", "--no-vis"}, 2, {"--no-vis", ".map"}},
      {{"compile", "none.bsp", "--wad", "none.wad"}, 2, {"--wad", ".map"}},
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

TEST_F(CompileProgram, PicturesOfAFolderAreTextures) {
  folder_.write("room.map", lit_room());
  const formats::Palette palette = artgen::make_palette();
  std::filesystem::create_directory(folder_.path() / "art");
  const std::vector<std::uint8_t> grey(32 * 16, 5);
  const base::ByteVector png = formats::write_png(grey, 32, 16, palette).value();
  folder_.write("art/wall.png", std::string(base::as_text(png)));
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--textures", "art"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const formats::Bsp bsp = read_level("room.bsp");
  ASSERT_EQ(bsp.miptexes.size(), 1u);
  EXPECT_EQ(bsp.miptexes[0].name, "wall");
  EXPECT_EQ(bsp.miptexes[0].width, 32u);
  EXPECT_EQ(bsp.miptexes[0].mips[0], grey);
  // The same as a WAD, for editors.
  const ProgramRun wad = run_program(folder_.path(), {"compile", "--textures", "art", "-o", "art.wad"});
  ASSERT_EQ(wad.exit_status, 0) << wad.err;
  ASSERT_EQ(
      run_program(folder_.path(), {"compile", "room.map", "--wad", "art.wad", "-o", "b.bsp"}).exit_status, 0);
  EXPECT_EQ(read_level("b.bsp").miptexes, bsp.miptexes);
  const ProgramRun without = run_program(folder_.path(), {"compile", "room.map", "--textures", "nowhere"});
  EXPECT_EQ(without.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(without.err)) << without.err;
  EXPECT_THAT(without.err, HasSubstr("nowhere"));
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
