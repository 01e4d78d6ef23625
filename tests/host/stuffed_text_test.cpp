// Lines that a server sends for the player's console.
#include "host/session/stuffed_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "client/input/key_names.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

TEST(StuffedText, OnlyHarmlessLinesAreSafe) {
  for (const char* line :
       {"play misc/hello.wav", "fog 0.1", "fov 120", "impulse 12", "v_cshift 1 2 3 4", "r_wateralpha 0.5",
        "alias tossrune \"impulse 20\"", "bind x +attack", "bind x \"+attack; impulse 2\"", "BF", "-attack",
        "+showscores", "color 4 4", "bf; bind x \"impulse 2\"; bind y +jump", "crosshair 0"})
    EXPECT_TRUE(host::may_be_stuffed(line)) << line;
  for (const char* line :
       {"play x; quit", "bind w quit", "bind w \"impulse 1; quit\"", "alias x \"rcon_password y\"",
        "exec evil.cfg", "quit", "connect 10.0.0.1", "unbindall", "rcon_password x", "-attack; quit", "rune",
        "bind x rune", "bind x \"color 4\"", "name thief", "set fov 1", "alias", "bind w", ""})
    EXPECT_FALSE(host::may_be_stuffed(line)) << line;
}

TEST(StuffedText, AliasesOfTheServerAreSafe) {
  for (const char* line : {"rune", "RUNE; bf", "bind x rune", "alias two \"rune; rune\""})
    EXPECT_TRUE(host::may_be_stuffed(line, {"rune"})) << line;
  EXPECT_FALSE(host::may_be_stuffed("rune; quit", {"rune"}));
}

class StuffedTextInAGame : public ::testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_QUAKEC();
    game_.emplace(std::vector<std::string>{"map small", "fov 100", "alias own \"echo mine\"", "bind x own"});
    ASSERT_TRUE(game_->run_until_playing());
    game_->run(0.1);
  }
  void send(std::string_view line, bool is_trusted = false) {
    game_->host().stuffed_text.run(game_->host(), line, is_trusted);
    game_->run(0.1);
  }
  void leave() {
    game_->command("disconnect");
    game_->run(0.1);
  }
  std::string value(std::string_view name) { return game_->variables().variables().find(name)->text; }
  std::string bound(std::string_view key) {
    return game_->host().input.bindings.commands(*client::find_key(key));
  }
  const std::string* alias(std::string_view name) { return game_->host().console.commands.find_alias(name); }
  std::optional<HeadlessHost> game_;
};

TEST_F(StuffedTextInAGame, IsUndoneWhenThePlayerLeaves) {
  send("fov 60");
  send("fov 70");
  send("r_wateralpha 0.5");
  send("alias own \"impulse 9\"");
  send("alias rune \"impulse 20\"");
  send("bind x rune");
  send("bind x \"impulse 20\"");
  send("v_cshift 255 0 0 128");
  EXPECT_EQ(value("fov"), "70");
  EXPECT_EQ(*alias("own"), "impulse 9");
  EXPECT_EQ(*alias("rune"), "impulse 20");
  EXPECT_EQ(bound("x"), "impulse 20");
  EXPECT_EQ(game_->host().video.server_tint.opacity, 0.5f);
  leave();
  EXPECT_EQ(value("fov"), "100");
  EXPECT_EQ(value("r_wateralpha"), "1");
  EXPECT_EQ(*alias("own"), "echo mine");
  EXPECT_EQ(alias("rune"), nullptr);
  EXPECT_EQ(bound("x"), "own");
  EXPECT_EQ(game_->host().video.server_tint.opacity, 0);
}

TEST_F(StuffedTextInAGame, MayRunItsOwnAliasesButNotThePlayers) {
  send("own");
  EXPECT_TRUE(game_->has_printed("The server's command \"own\" was refused (cl_stufftext)."));
  EXPECT_FALSE(game_->has_printed("mine"));
  send("alias hello \"echo from the server\"");
  send("bind x hello; hello");
  EXPECT_EQ(bound("x"), "hello");
  EXPECT_TRUE(game_->has_printed("from the server"));
  game_->command("alias hello \"echo changed\"");
  game_->run(0.1);
  send("hello");
  EXPECT_FALSE(game_->has_printed("changed"));
}

TEST_F(StuffedTextInAGame, RunsTheHarmlessCommandsOfALine) {
  send("fov 60; quit; color 4 13; bind x \"impulse 5\"");
  EXPECT_EQ(value("fov"), "60");
  EXPECT_EQ(value("topcolor"), "4");
  EXPECT_EQ(value("bottomcolor"), "13");
  EXPECT_EQ(bound("x"), "impulse 5");
  EXPECT_TRUE(game_->has_printed("The server's command \"quit\" was refused (cl_stufftext)."));
  leave();
  EXPECT_EQ(value("fov"), "100");
  EXPECT_EQ(value("topcolor"), "0");
  EXPECT_EQ(value("bottomcolor"), "0");
  EXPECT_EQ(bound("x"), "own");
}

// Games send "-attack" to players who have died.
TEST_F(StuffedTextInAGame, HoldsButtonsUntilThePlayerLeaves) {
  const auto is_held = [&] {
    return game_->host().input.player.buttons()[client::Button::kAttack].is_down();
  };
  send("+attack");
  EXPECT_TRUE(is_held());
  send("-attack");
  EXPECT_FALSE(is_held());
  send("+attack");
  leave();
  EXPECT_FALSE(is_held());
}

TEST_F(StuffedTextInAGame, KeepsWhatThePlayerHasChangedSince) {
  send("fov 60");
  game_->command("fov 95");
  leave();
  EXPECT_EQ(value("fov"), "95");
}

TEST_F(StuffedTextInAGame, IsUndoneBeforeTheSettingsAreSaved) {
  send("fov 60");
  game_->command("quit");
  game_->run(0.1);
  EXPECT_EQ(value("fov"), "100");
}

TEST_F(StuffedTextInAGame, RefusesHarmfulLinesAndSaysSoOnce) {
  send("name thief");
  send("name thief");
  send("bind w quit");
  send("cl_serverextension_download 1");
  EXPECT_FALSE(game_->has_printed("cl_serverextension_download")) << "not a command of ours";
  EXPECT_EQ(value("name"), "player");
  EXPECT_NE(bound("w"), "quit");
  EXPECT_EQ(std::count(game_->lines().begin(), game_->lines().end(),
                       "The server's command \"name\" was refused (cl_stufftext)."),
            1);
}

TEST_F(StuffedTextInAGame, FollowsTheRule) {
  game_->command("cl_stufftext 0");
  game_->run(0.1);
  send("fov 60");
  EXPECT_EQ(value("fov"), "100");
  game_->command("cl_stufftext 2");
  game_->run(0.1);
  send("name guest; fov 60");
  EXPECT_EQ(value("name"), "guest");
  EXPECT_EQ(value("fov"), "60");
}

TEST_F(StuffedTextInAGame, MayDoAnythingInAGameOnThisMachine) {
  send("skill 3", true);
  send("fov 60", true);
  EXPECT_EQ(value("skill"), "3");
  leave();
  EXPECT_EQ(value("skill"), "3");
  EXPECT_EQ(value("fov"), "100");
}

TEST_F(StuffedTextInAGame, MusicFollowsTheCommands) {
  const auto track = [&] { return game_->session().connection()->state().game().music_track; };
  send("cd play 5");
  EXPECT_EQ(track(), 5);
  send("music track07");
  EXPECT_EQ(track(), 7);
  send("music_pause");
  EXPECT_TRUE(game_->host().sound.is_music_paused);
  send("cd resume");
  EXPECT_FALSE(game_->host().sound.is_music_paused);
  send("music_stop");
  EXPECT_EQ(track(), 0);
  send("music nothing");
  EXPECT_TRUE(game_->has_printed("music TRACK: a number"));
  send("playvol misc/menu1.wav 0.5");
  send("playvol misc/menu1.wav");
  EXPECT_TRUE(game_->has_printed("playvol FILE VOLUME"));
}

}  // namespace
}  // namespace temblor::test
