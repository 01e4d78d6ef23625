// `temblor compile` that continues: --watch, and interrupted visibility.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include "app/compile/compile_program.h"
#include "app/files/child_process.h"
#include "app/program.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(CompileProgram, WatchCompilesAfterASave) {
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
  folder_.write("room.map", lit_room() + "{");  // an error, but not the end
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  folder_.write("room.map", lit_room() + point_text("monster_ogre", {50, 0, 30}));
  EXPECT_TRUE(wait_for([&] { return has("monster_ogre"); }));
}

TEST_F(CompileProgram, WatchRebuildsEverythingWithClean) {
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

TEST_F(CompileProgram, ResumesInterruptedVisibility) {
  folder_.write("hall.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "hall.map"}).exit_status, 0);
  const std::string old_level = read_text(folder_.path() / "hall.bsp");
  folder_.write("hall.map", hall_of_pillars(effort(14, 10)));
  const std::string map = (folder_.path() / "hall.map").string();
  const auto exists = [&](const char* name) { return std::filesystem::exists(folder_.path() / name); };
  // If it is interrupted before visibility begins, nothing is saved, so try again later.
  for (int wait_ms = 100; wait_ms < 10'000 && !exists("hall.visibility"); wait_ms += wait_ms / 2) {
    auto program =
        app::ChildProcess::start({TEMBLOR_PROGRAM, "compile", map, "--no-light", "--threads", "1"});
    ASSERT_TRUE(program.ok()) << program.error().message();
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
  }
  ASSERT_TRUE(exists("hall.visibility"));
  ASSERT_EQ(read_text(folder_.path() / "hall.bsp"), old_level)
      << "it finished before it could be interrupted";
  // The old level is unchanged.
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

TEST_F(CompileProgram, WatchEndsWhenVisibilityIsInterrupted) {
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
  EXPECT_FALSE(exists("hall.bsp")) << "it finished before it could be interrupted";
}

}  // namespace
}  // namespace temblor::test
