// Lockstep games and replays from the console. Games of several players are in tests/lockstep.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "client/demo/demo_session.h"
#include "host/headless_host.h"
#include "host/session/session.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

TEST(LockstepCommand, AGameOfOnePlayerLeavesAReplayThatPlays) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost headless({"lockstep small 1"});
  ASSERT_TRUE(headless.run_until_playing());
  EXPECT_EQ(headless.session().server(), nullptr);
  headless.command("+forward");
  headless.run(2);
  headless.command("disconnect");
  headless.run(0.1);
  ASSERT_TRUE(headless.has_printed("Replay saved: id1/lockstep0000.replay"));
  headless.command("playreplay lockstep0000.replay");
  headless.run(0.1);
  EXPECT_TRUE(headless.has_printed("on small, the same game"));
  ASSERT_NE(headless.demo(), nullptr);
  EXPECT_GT(headless.demo()->end_s() - headless.demo()->begin_s(), 1.5);
  headless.run(1);
  // The next one gets another name.
  headless.command("lockstep small 1");
  ASSERT_TRUE(headless.run_until_playing());
  headless.command("map small");
  headless.run(0.1);
  EXPECT_TRUE(headless.has_printed("Replay saved: id1/lockstep0001.replay"));
}

TEST(LockstepCommand, BadArgumentsLeaveTheGameRunning) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost headless({"map small"});
  ASSERT_TRUE(headless.run_until_playing());
  for (const char* const line : {"lockstep", "lockstep small 0", "lockstep small 5", "lockstep small two",
                                 "lockstep small 2 0", "lockstep small 2 37", "lockstep small 2 4 5"}) {
    headless.command(line);
    headless.run(0.1);
    EXPECT_TRUE(headless.has_printed("lockstep MAP [PLAYERS [DELAY]]")) << line;
  }
  headless.command("lockstep no_such_level 1");
  headless.command("lockstep_join");
  headless.command("lockstep_join 127.0.0.1");
  headless.command("playreplay");
  headless.command("playreplay no_such_file");
  headless.folder().write("id1/bad.replay", std::string_view("no replay"));
  headless.command("playreplay bad.replay");
  headless.command("playreplay bad.replay 5");
  headless.run(0.1);
  EXPECT_TRUE(headless.has_printed("no_such_level"));
  EXPECT_TRUE(headless.has_printed("lockstep_join HOST[:PORT]"));
  EXPECT_TRUE(headless.has_printed("no network is available"));
  EXPECT_TRUE(headless.has_printed("playreplay FILE [PLAYER]"));
  EXPECT_TRUE(headless.has_printed("no_such_file"));
  EXPECT_TRUE(headless.has_printed("bad.replay: this is not a replay"));
  EXPECT_TRUE(headless.session().is_playing());
  EXPECT_NE(headless.session().server(), nullptr);
}

}  // namespace
}  // namespace temblor::test
