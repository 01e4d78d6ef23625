// Lines that a server sends for the player's console.
#include "host/session/stuffed_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "client/input/key_names.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "host/session/games.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

TEST(StuffedText, OnlyHarmlessLinesAreSafe) {
  for (const char* line :
       {"play misc/hello.wav", "fog 0.1", "fov 120", "impulse 12", "v_cshift 1 2 3 4", "r_wateralpha 0.5",
        "alias tossrune \"impulse 20\"", "bind x +attack", "bind x \"+attack; impulse 2\"", "BF", "-attack",
        "+showscores", "color 4 4", "bind x \"color 4; fov 30\"", "bf; bind x \"impulse 2\"; bind y +jump",
        "crosshair 0"})
    EXPECT_TRUE(host::may_be_stuffed(line)) << line;
  for (const char* line :
       {"play x; quit", "bind w quit", "bind w \"impulse 1; quit\"", "alias x \"rcon_password y\"",
        "exec evil.cfg", "quit", "connect 10.0.0.1", "unbindall", "rcon_password x", "-attack; quit", "rune",
        "bind x rune", "wait", "name thief", "set fov 1", "alias", "bind w", ""})
    EXPECT_FALSE(host::may_be_stuffed(line)) << line;
}

TEST(StuffedText, AliasesOfTheServerAreSafe) {
  const command::Aliases aliases = {{"rune", {"impulse 20", command::Source::kServer}},
                                    {"own", {"quit", command::Source::kPlayer}}};
  for (const char* line : {"rune", "RUNE; bf", "bind x rune", "alias two \"rune; rune\""})
    EXPECT_TRUE(host::may_be_stuffed(line, aliases)) << line;
  for (const char* line : {"rune; quit", "own", "bind x own"})
    EXPECT_FALSE(host::may_be_stuffed(line, aliases)) << line;
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
  // Empty: there is none.
  std::string alias(std::string_view name) {
    const command::Alias* const found = game_->host().console.commands.find_alias(name);
    return found != nullptr ? found->text : std::string();
  }
  // The file that `writeconfig now` writes.
  std::string saved_settings() {
    return std::string(base::as_text(read_file(game_->folder().path() / "id1/now.cfg")));
  }
  // All that a line can change.
  std::string settings() {
    std::string text = game_->host().input.bindings.to_text();
    for (const auto& [name, alias] : game_->host().console.commands.aliases())
      text += fmt::format("alias {} {} {}\n", name, alias.text, static_cast<int>(alias.source));
    for (const command::Variable* variable : game_->variables().variables().all())
      if (!variable->is_user_made || !variable->text.empty())
        text += fmt::format("{} {} {}\n", variable->name, variable->text, variable->is_kept);
    return text;
  }
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
  EXPECT_EQ(alias("own"), "impulse 9");
  EXPECT_EQ(alias("rune"), "impulse 20");
  EXPECT_EQ(bound("x"), "impulse 20");
  EXPECT_EQ(game_->host().video.server_tint.opacity, 0.5f);
  leave();
  EXPECT_EQ(value("fov"), "100");
  EXPECT_EQ(value("r_wateralpha"), "1");
  EXPECT_EQ(alias("own"), "echo mine");
  EXPECT_EQ(alias("rune"), "");
  EXPECT_EQ(bound("x"), "own");
  EXPECT_EQ(game_->host().video.server_tint.opacity, 0);
}

TEST_F(StuffedTextInAGame, DoesNotRunAfterThePlayerHasLeft) {
  game_->command("wait; wait; wait; disconnect; wait; echo left");
  send("fov 60; bind x +attack");
  game_->run(0.2);
  EXPECT_TRUE(game_->has_printed("left"));
  EXPECT_EQ(value("fov"), "100");
  EXPECT_EQ(bound("x"), "own");
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

// Each way to change a setting.
TEST_F(StuffedTextInAGame, IsUndoneAndNeverSavedHoweverItIsSent) {
  game_->command("cl_stufftext 2; sensitivity 7; r_wateralpha 0.25; seta mine 1; alias more \"echo more\"");
  game_->run(0.1);
  game_->folder().write("id1/evil.cfg", "fov 33; bind x evil\nalias own \"echo evil\"");
  for (const char* line : {"unbind x",
                           "unbindall",
                           "cycle fov 50 60",
                           "inc sensitivity 2",
                           "toggle freelook",
                           "reset fov",
                           "resetall; cl_stufftext 2",
                           "set fov 44",
                           "seta mine 2",
                           "exec evil.cfg",
                           "fov 50;crosshair 3",
                           "bind x quit;alias y quit",
                           "wait;wait;fov 55;wait;unbind x",
                           "bind x \"fov 20\";writeconfig now",
                           "alias deep \"fov 51; wait; exec evil.cfg\";deep",
                           "unalias own",
                           "unaliasall",
                           "color 4 5",
                           "name thief",
                           "sizedown",
                           "alias own \"echo mine\"",
                           "exec default.cfg;fov 61",
                           "seta theirs 3;sensitivity 9"}) {
    SCOPED_TRACE(line);
    game_->command("writeconfig now");
    game_->run(0.02);
    const std::string before = settings(), saved = saved_settings();
    send(line);
    EXPECT_FALSE(settings() == before) << "it has changed something";
    game_->command("writeconfig now");
    game_->run(0.02);
    EXPECT_TRUE(saved_settings() == saved);
    game_->host().stuffed_text.restore(game_->host());
    EXPECT_TRUE(settings() == before);
  }
}

TEST_F(StuffedTextInAGame, KeysAndAliasesOfTheServerAreItsText) {
  send("alias zoom \"fov 30\"; bind x zoom; bind y \"fov 40\"");
  game_->press(*client::find_key("x"));
  game_->run(0.1);
  EXPECT_EQ(value("fov"), "30");
  leave();
  EXPECT_EQ(value("fov"), "100");
}

TEST_F(StuffedTextInAGame, MayNotRunMoreThroughAKeyThanByItself) {
  game_->command("cl_stufftext 2");
  game_->run(0.1);
  send("bind x \"name thief\"");
  game_->command("cl_stufftext 1");
  game_->press(*client::find_key("x"));
  game_->run(0.1);
  EXPECT_EQ(value("name"), "player");
  // The player's own keys may do anything.
  game_->command("bind x \"name hero\"");
  game_->run(0.1);
  game_->release(*client::find_key("x"));
  game_->press(*client::find_key("x"));
  game_->run(0.1);
  EXPECT_EQ(value("name"), "hero");
}

TEST_F(StuffedTextInAGame, KeepsAChangeBetweenTwoOfTheServer) {
  send("fov 60");
  game_->command("fov 95");
  game_->run(0.1);
  send("fov 70");
  leave();
  EXPECT_EQ(value("fov"), "95");
}

TEST_F(StuffedTextInAGame, WaitsNoLongerThanItsGame) {
  game_->command("cl_stufftext 2");
  game_->run(0.1);
  std::string line = "fov 60";
  for (int i = 0; i < 20; ++i) line += ";wait";
  send(line + ";name thief; echo arrived");
  EXPECT_EQ(value("fov"), "60");
  host::disconnect(game_->host());  // by the menu: a typed line runs after those that wait
  game_->command("map small");
  ASSERT_TRUE(game_->run_until_playing());
  game_->run(0.5);
  EXPECT_EQ(value("fov"), "100");
  EXPECT_EQ(value("name"), "player");
  EXPECT_FALSE(game_->has_printed("arrived"));
}

// A value of the command line is not saved, also after a server has changed it meanwhile.
TEST_F(StuffedTextInAGame, LeavesTheCommandLineItsValue) {
  game_->command("fov 105; writeconfig");
  game_->run(0.1);
  game_->restart([](command::Variables& variables) { return variables.set("fov", "120"); });
  game_->command("map small");
  ASSERT_TRUE(game_->run_until_playing());
  send("fov 60");
  leave();
  EXPECT_EQ(value("fov"), "120");
  game_->command("writeconfig now");
  game_->run(0.1);
  EXPECT_NE(saved_settings().find("fov 105\n"), std::string::npos);
}

}  // namespace
}  // namespace temblor::test
