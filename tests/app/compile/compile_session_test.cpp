// Runs of `temblor compile` that fail or are interrupted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "app/files/child_process.h"
#include "app/program.h"
#include "compiler/build_file.h"
#include "compiler/compile_level.h"
#include "compiler/vis/build_visibility.h"
#include "formats/levels/bsp.h"
#include "support/levels/room_map.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

std::string session_room(const char* keys = "") {
  return entity_text("worldspawn", keys, walls_text({-128, -128, 0}, {128, 128, 128}, "wall")) +
         point_text("info_player_start", {0, 0, 32}) + entity_text("light", "\"origin\" \"64 64 96\"");
}

// Stops visibility when part of it is done.
class Stopper : public compiler::CompileWatcher {
 public:
  bool progress(std::size_t done, std::size_t total) override { return done * 2 < total; }
};

class CompileSessionTest : public ::testing::Test {
 protected:
  ProgramRun compile(std::vector<std::string> words) {
    words.insert(words.begin(), "compile");
    return run_program(folder_.path(), words);
  }
  fs::path path(const char* name) const { return folder_.path() / name; }
  bool exists(const char* name) const { return fs::exists(path(name)); }

  TemporaryFolder folder_;
};

TEST_F(CompileSessionTest, OverwritesNeitherTheMapNorItsOwnFiles) {
  folder_.write("room.map", session_room());
  fs::create_symlink("room.map", path("link.bsp"));
  for (const char* out : {"room.map", "./room.map", "link.bsp", "room.lit", "room.pts", "room.build"}) {
    const ProgramRun run = compile({"room.map", "-o", out});
    EXPECT_EQ(run.exit_status, 2) << out;
    EXPECT_THAT(run.err, HasSubstr("-o")) << out;
    EXPECT_EQ(read_text(path("room.map")), session_room()) << out;
  }
}

TEST_F(CompileSessionTest, LightsALevelWithAnUppercaseNameInPlace) {
  folder_.write("room.map", session_room());
  ASSERT_EQ(compile({"room.map", "--only", "bsp", "--clean"}).exit_status, 0);
  fs::rename(path("room.bsp"), path("ROOM.BSP"));
  const std::string before = read_text(path("ROOM.BSP"));
  ASSERT_EQ(compile({"ROOM.BSP"}).exit_status, 0);
  EXPECT_NE(read_text(path("ROOM.BSP")), before);
  EXPECT_FALSE(exists("ROOM.bsp"));
  EXPECT_EQ(compile({"ROOM.BSP", "--only", "bsp"}).exit_status, 2) << "it has no brushes";
}

TEST_F(CompileSessionTest, ShardsOfALevelThatLeaks) {
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  folder_.write("leak.map", entity_text("worldspawn", "", walls.substr(walls.find("}\n") + 2)) +
                                point_text("info_player_start", {0, 0, 32}) +
                                entity_text("light", "\"origin\" \"64 64 96\""));
  ASSERT_EQ(compile({"leak.map"}).exit_status, 0);
  const std::string whole = read_text(path("leak.bsp"));
  for (const char* what : {"--shard=1/1", "--merge"}) {
    const ProgramRun run = compile({"leak.map", "--only", "vis", what});
    EXPECT_EQ(run.exit_status, 1);
    EXPECT_THAT(run.err, HasSubstr("leaks"));
  }
  ASSERT_EQ(compile({"leak.map", "--only", "light", "--shard", "1/1"}).exit_status, 0);
  ASSERT_EQ(compile({"leak.map", "--only", "light", "--merge"}).exit_status, 0);
  EXPECT_EQ(read_text(path("leak.bsp")), whole);
  EXPECT_TRUE(exists("leak.pts"));
}

TEST_F(CompileSessionTest, ShardsStayUntilTheLevelIsWritten) {
  folder_.write("room.map", session_room());
  const ProgramRun shard = compile({"room.map", "--only", "light", "--shard", "1/1"});
  ASSERT_EQ(shard.exit_status, 0) << shard.err;
  fs::create_directory(path("room.bsp"));
  EXPECT_EQ(compile({"room.map", "--only", "light", "--merge"}).exit_status, 1);
  EXPECT_TRUE(exists("room.light-1-of-1"));
  fs::remove(path("room.bsp"));
  EXPECT_EQ(compile({"room.map", "--only", "light", "--merge"}).exit_status, 0);
  EXPECT_FALSE(exists("room.light-1-of-1"));
}

// The next run resumes from the saved visibility of a .bsp.
TEST_F(CompileSessionTest, ResumesInterruptedVisibilityOfALevel) {
  std::string brushes = walls_text({0, 0, 0}, {512, 512, 128}, "wall");
  for (const int x : {96, 224, 352})
    for (const int y : {80, 208, 336}) brushes += box_text({x, y, 0}, {x + 32, y + 32, 128}, "pillar");
  folder_.write("hall.map",
                entity_text("worldspawn", "", brushes) + point_text("info_player_start", {8, 8, 40}));
  ASSERT_EQ(compile({"hall.map", "--only", "bsp", "--clean"}).exit_status, 0);
  const std::vector<std::string> next_share = {"hall.bsp", "--only", "vis", "--shard", "1/9999"};
  ASSERT_EQ(compile(next_share).exit_status, 0);
  const std::size_t rebuilt_bytes = read_text(path("hall.vis-1-of-9999")).size();

  const std::string level = read_text(path("hall.bsp"));
  compiler::Build build =
      compiler::make_build_from_level(formats::read_bsp(base::as_bytes(level)).value(), {}, true).value();
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  Stopper stopper;
  ASSERT_FALSE(compiler::make_visibility(compiler::VisibilityKind::kFull, jobs, stopper, build).ok());
  ASSERT_GT(build.visibility_state.size(), rebuilt_bytes);
  folder_.write("hall.visibility", build.visibility_state);
  ASSERT_EQ(compile(next_share).exit_status, 0);
  EXPECT_GE(read_text(path("hall.vis-1-of-9999")).size(), build.visibility_state.size());
}

// The level is a pipe, so the first run does not end before the pipe is read.
TEST_F(CompileSessionTest, WatchNoticesASaveDuringTheFirstRun) {
  const auto part = [](const char* texture) {
    return entity_text("worldspawn", "", box_text({32, 32, 0}, {64, 64, 64}, texture));
  };
  folder_.write("room.map",
                session_room() + entity_text("misc_external_map", "\"_external_map\" \"part.map\""));
  folder_.write("part.map", part("sooner"));
  ASSERT_EQ(mkfifo(path("room.bsp").c_str(), 0600), 0);
  const auto program =
      app::ChildProcess::start({TEMBLOR_PROGRAM, "compile", path("room.map").string(), "--watch", "--fast"});
  ASSERT_TRUE(program.ok()) << program.error().message();
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));  // it has read the map by now
  folder_.write("part.map", part("later"));
  const auto next_level = [&]() -> std::string {
    const std::string command =
        "timeout 30 cat '" + path("room.bsp").string() + "' >'" + path("level").string() + "'";
    return std::system(command.c_str()) == 0 ? read_text(path("level")) : "none came";
  };
  EXPECT_THAT(next_level(), HasSubstr("sooner"));
  EXPECT_THAT(next_level(), HasSubstr("later"));
}

}  // namespace
}  // namespace temblor::test
