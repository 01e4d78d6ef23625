// Which settings hold, and which are kept: the player's, the command line's, those of another game.
#include <gtest/gtest.h>

#include "host/commands/configuration.h"
#include "host/played_host.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

std::string value_of(const PlayedHost& played, std::string_view name) {
  return played.variables().variables().find(name)->text;
}

void quit(PlayedHost& io_played) {
  io_played.command("quit");
  io_played.run(0.1);
}

base::Status on_the_command_line(command::Variables& io_variables) {
  TRY_STATUS(io_variables.set("fov", "110"));
  TRY_STATUS(io_variables.set("sensitivity", "9"));
  return io_variables.set("zoom_fov", "40");
}

TEST(Settings, TheCommandLineHoldsForOneRun) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"fov 100; sensitivity 5"});
  quit(played);
  played.start_again(on_the_command_line);
  EXPECT_EQ(value_of(played, "fov"), "110");
  EXPECT_EQ(value_of(played, "sensitivity"), "9");
  EXPECT_EQ(value_of(played, "zoom_fov"), "40");
  played.command("sensitivity 6");
  played.command("zoom_speed 4");
  quit(played);
  played.start_again();
  EXPECT_EQ(value_of(played, "fov"), "100") << "as the player had it before";
  EXPECT_EQ(value_of(played, "sensitivity"), "6") << "what he changes himself is his";
  EXPECT_EQ(value_of(played, "zoom_fov"), "30") << "never anything but the default";
  EXPECT_EQ(value_of(played, "zoom_speed"), "4");
}

// --- Several games.

constexpr std::string_view kQuick = "host_maxfps 10000\nr_threads 1\n";

void write_settings(const PlayedHost& played, const std::string& folder, std::string_view text) {
  played.folder().write(folder + "/temblor.cfg", std::string(kQuick) + std::string(text));
}

void change_to(PlayedHost& io_played, std::string_view game) {
  io_played.command("game " + std::string(game));
  io_played.run(0.1);
}

TEST(Settings, AnotherGameHasItsOwn) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"sensitivity 5; sv_gravity 100; bind x \"echo first\""});
  write_settings(played, "second", "fov 120\nunbindall\nbind y \"echo second\"\n");
  change_to(played, "second");
  EXPECT_EQ(value_of(played, "fov"), "120");
  EXPECT_EQ(value_of(played, "sensitivity"), "3") << "the other game's";
  EXPECT_EQ(value_of(played, "sv_gravity"), "800");
  played.press(platform::Key{'x'});
  played.press(platform::Key{'y'});
  played.run(0.05);
  EXPECT_FALSE(played.has_printed("first"));
  EXPECT_TRUE(played.has_printed("second"));
  change_to(played, "id1");
  EXPECT_EQ(value_of(played, "fov"), "90");
  EXPECT_EQ(value_of(played, "sensitivity"), "5");
}

TEST(Settings, AGameWithoutAnyBeginsWithThoseOfId1AndKeepsItsOwnThen) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"sensitivity 5"});
  write_settings(played, "second", "fov 120\n");
  played.folder().write("third/readme.txt", std::string_view("nothing"));
  change_to(played, "second");
  change_to(played, "third");
  EXPECT_EQ(value_of(played, "sensitivity"), "5");
  EXPECT_EQ(value_of(played, "fov"), "90");
  played.command("sensitivity 7");
  change_to(played, "id1");
  EXPECT_EQ(value_of(played, "sensitivity"), "5");
  change_to(played, "third");
  EXPECT_EQ(value_of(played, "sensitivity"), "7");
}

TEST(Settings, TheCommandLineHoldsInAnotherGameTooButNotOverThePlayer) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played;
  write_settings(played, "id1", "");
  write_settings(played, "second", "fov 120\nsensitivity 4\n");
  played.start_again(on_the_command_line);
  played.command("sensitivity 6");
  change_to(played, "second");
  EXPECT_EQ(value_of(played, "fov"), "110");
  EXPECT_EQ(value_of(played, "sensitivity"), "4");
}

// A folder that holds this cannot be written to, as far as the program can see, whoever runs the test.
void forbid_writing(const SmallGame& game, const std::string& folder) {
  game.folder().write(folder + "/.temblor-may-write/x", std::string_view("x"));
}

TEST(Settings, OfFoldersThatMayNotBeWrittenAreFoundWhateverIsPlayed) {
  const SmallGame game;
  const TemporaryFolder user;
  game.folder().write("id1/temblor.cfg", std::string_view("// came with the game"));
  game.folder().write("mod/readme.txt", std::string_view("nothing"));
  forbid_writing(game, "id1");
  user.write("id1/temblor.cfg", std::string_view("// the player's of id1"));
  user.write("id1/temblor.history", std::string_view("typed"));
  const host::GameFolders folders{game.path(), {"mod"}, user.path()};
  const auto read = [&] {
    const auto data = host::GameData::open(folders);
    EXPECT_TRUE(data.ok());
    return host::read_commands(**data, "temblor.cfg").value();
  };
  EXPECT_EQ(read(), "// the player's of id1");
  EXPECT_EQ(host::read_history(**host::GameData::open(folders)), "typed");
  game.folder().write("mod/temblor.cfg", std::string_view("// of mod"));
  EXPECT_EQ(read(), "// of mod");
  forbid_writing(game, "mod");
  EXPECT_EQ(read(), "// of mod");
  user.write("mod/temblor.cfg", std::string_view("// the player's of mod"));
  EXPECT_EQ(read(), "// the player's of mod");
}

TEST(GameData, WhatThePlayerMadeIsPlayedWhereTheGameMayNotBeWritten) {
  const SmallGame game;
  const TemporaryFolder user;
  forbid_writing(game, "id1");
  user.write("id1/maps/small.bsp", std::string_view("mine"));
  user.write("id1/maps/more.bsp", std::string_view("more"));
  const auto games = host::mount_games({game.path(), {}, user.path()});
  ASSERT_TRUE(games.ok());
  EXPECT_EQ(games->write_folders.back(), user.path() / "id1");
  EXPECT_EQ(games->files.where("maps/small.bsp"), user.path() / "id1/maps/small.bsp");
  EXPECT_TRUE(games->files.contains("maps/more.bsp"));
  EXPECT_TRUE(games->files.contains("gfx/palette.lmp"));
}

TEST(GameData, OfWritableGamesTheUsersFolderIsAnotherGames) {
  const SmallGame game;
  const TemporaryFolder user;
  user.write("id1/maps/more.bsp", std::string_view("of another id1"));
  const auto games = host::mount_games({game.path(), {}, user.path()});
  ASSERT_TRUE(games.ok());
  EXPECT_EQ(games->write_folders.back(), game.path() / "id1");
  EXPECT_FALSE(games->files.contains("maps/more.bsp"));
}

// As root everything may be written.
TEST(GameData, NothingIsWrittenBesideAnInstalledGame) {
  const SmallGame game;
  const TemporaryFolder user;
  const auto games = host::mount_games({game.path(), {}, user.path() / "new", true});
  ASSERT_TRUE(games.ok());
  EXPECT_EQ(games->write_folders.back(), user.path() / "new/id1");
  EXPECT_TRUE(std::filesystem::is_directory(user.path() / "new/id1"));
}

}  // namespace
}  // namespace temblor::test
