// Autosaves, and dead players who continue from the last save.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/check.h"
#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string replace_once(std::string program, const std::string& old, const std::string& now) {
  const std::size_t at = program.find(old);
  CHECK(at != std::string::npos);
  return program.replace(at, old.size(), now);
}

// The small program, in which a dead player who presses a button restarts the level.
std::string mortal_program() {
  return replace_once(
      small_program(), "void() PlayerPreThink = {};",
      "void() PlayerPreThink = { if (self.health <= 0 && !self.deadflag) "
      "if (self.button0 || self.button2) { self.deadflag = 2; localcmd(\"restart\\n\"); } };");
}

bool has_save(const ServedGame& served, const std::string& name) {
  return std::filesystem::exists(served.folder().path() / "id1" / (name + ".sav"));
}

constexpr net::Move kFire{.buttons = 1}, kJump{.buttons = 2};

TEST(Saving, ASinglePlayerGameIsSavedAutomatically) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(2);
  EXPECT_TRUE(has_save(served, "autosave")) << "on arrival";
  EXPECT_EQ(server::take_autosave_name(served.server()), "autosave");
  EXPECT_EQ(server::take_autosave_name(served.server()), "") << "reported once";
  served.run(60);
  EXPECT_EQ(server::take_autosave_name(served.server()), "");
  served.run(130);
  EXPECT_EQ(server::take_autosave_name(served.server()), "autosave") << "three minutes later";
}

TEST(Saving, MultiplayerGamesAreNot) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
  served.run(10);
  server::shut_down(served.server(), "the end");
  EXPECT_FALSE(has_save(served, "autosave"));
  EXPECT_THAT(served.console(), Not(HasSubstr("save")));
}

TEST(Saving, NorIfThePlayerTurnsItOff) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  served.command("sv_autosave 0");
  ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
  served.run(10);
  EXPECT_FALSE(server::autosaves_on_leave(served.server()));
  server::shut_down(served.server(), "the end");
  EXPECT_FALSE(has_save(served, "autosave"));
}

TEST(Saving, LeavingAGameSavesIt) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
  served.run(1);
  EXPECT_FALSE(server::autosaves_on_leave(served.server())) << "there is nothing to lose yet";
  served.run(9);
  served.game().player(0).set(server::field::kHealth, 33.0f);
  served.run(0.1);
  EXPECT_TRUE(server::autosaves_on_leave(served.server()));
  served.command("map small");
  served.run(10);
  EXPECT_TRUE(has_save(served, "autosave2")) << "a new game has another name";
  served.command("load autosave");
  served.run(3);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 33);
}

TEST(Saving, DeadPlayersLoadTheLastSaveOrRestart) {
  SKIP_WITHOUT_QUAKEC();
  for (const bool jumps : {false, true}) {
    ServedGame served(mortal_program(), {.max_clients = 1});
    ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
    EXPECT_FALSE(server::can_resume_from_save(served.server())) << "there is no save yet";
    served.run(1);
    served.game().player(0).set(server::field::kHealth, 77.0f);
    served.command("save quick");
    served.run(0.1);
    EXPECT_TRUE(server::can_resume_from_save(served.server()));
    served.game().player(0).set(server::field::kHealth, -5.0f);
    served.run(0.5);
    EXPECT_EQ(served.game().player(0)[server::field::kHealth], -5) << "until the player presses a button";
    served.run(0.5, jumps ? kJump : kFire);
    served.run(3);
    EXPECT_EQ(served.game().player(0)[server::field::kHealth], jumps ? 100 : 77);
  }
}

TEST(Saving, AMissingSaveIsTriedOnlyOnce) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(mortal_program(), {.max_clients = 1});
  ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
  served.run(1);
  served.command("save quick");
  served.run(0.1);
  std::filesystem::remove(served.folder().path() / "id1/quick.sav");
  served.game().player(0).set(server::field::kHealth, -5.0f);
  served.run(0.5, kFire);
  EXPECT_THAT(served.console(), HasSubstr("quick.sav"));
  EXPECT_FALSE(server::can_resume_from_save(served.server()));
  EXPECT_LT(served.game().player(0)[server::field::kHealth], 0);
  served.game().player(0).set(server::field::kDeadFlag, 0.0f);  // as game code does once the button is up
  served.run(0.5, kFire);
  served.run(0.5);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 100);
}

// The level shows a mark a moment after its start, when its movers exist, as the shipped game's info_mark
// does.
TEST(Saving, ALoadedGameShowsTheMarksOfItsLevel) {
  SKIP_WITHOUT_QUAKEC();
  const std::string program = replace_once(
      small_program(), "void() info_player_start = {};",
      "void() mark_appears = { WriteByte(3, 9); WriteString(3, \"//temblor mark smile 1 2 3 4\\n\"); };"
      "void() info_player_start = { self.think = mark_appears; self.nextthink = time + 0.1; };");
  ServedGame served(program, {.max_clients = 1});
  const std::size_t me = served.add_client("one");
  ASSERT_TRUE(served.run_until_playing(me));
  EXPECT_EQ(served.marks(me), 1u);
  served.command("save quick");
  served.run(0.1);
  EXPECT_EQ(served.marks(me), 1u);
  served.command("load quick");
  served.run(3);
  EXPECT_EQ(served.marks(me), 2u) << "once again";
}

TEST(Saving, WithoutAutoloadDeadPlayersRestart) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(mortal_program(), {.max_clients = 1});
  served.command("sv_autoload 0");
  ASSERT_TRUE(served.run_until_playing(served.add_client("one")));
  served.run(1);
  served.game().player(0).set(server::field::kHealth, 77.0f);
  served.command("save quick");
  served.run(0.1);
  served.game().player(0).set(server::field::kHealth, -5.0f);
  served.run(0.5, kFire);
  served.run(1);
  EXPECT_EQ(served.game().player(0)[server::field::kHealth], 100);
}

}  // namespace
}  // namespace temblor::test
