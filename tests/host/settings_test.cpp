// Which settings are in effect, and which are saved: those of the player, the command line, and other mods.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/commands/configuration.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

std::string value(const HeadlessHost& host, std::string_view name) {
  return host.variables().variables().find(name)->text;
}

void quit(HeadlessHost& io_host) {
  io_host.command("quit");
  io_host.run(0.1);
}

base::Status set_on_command_line(command::Variables& io_variables) {
  TRY_STATUS(io_variables.set("fov", "110"));
  TRY_STATUS(io_variables.set("sensitivity", "9"));
  return io_variables.set("zoom_fov", "40");
}

TEST(Settings, CommandLineHoldsForOneRun) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"fov 100; sensitivity 5"});
  quit(host);
  host.restart(set_on_command_line);
  EXPECT_EQ(value(host, "fov"), "110");
  EXPECT_EQ(value(host, "sensitivity"), "9");
  EXPECT_EQ(value(host, "zoom_fov"), "40");
  host.command("sensitivity 6");
  host.command("zoom_speed 4");
  quit(host);
  host.restart();
  EXPECT_EQ(value(host, "fov"), "100") << "the player's value from before";
  EXPECT_EQ(value(host, "sensitivity"), "6") << "a value that the player changed is saved";
  EXPECT_EQ(value(host, "zoom_fov"), "30") << "the player never changed it";
  EXPECT_EQ(value(host, "zoom_speed"), "4");
}

TEST(Settings, AreCopiedToTheNamedFile) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"fov 100; bind F7 god; writeconfig Mine; writeconfig old.CFG"});
  host.run(0.1);
  const std::filesystem::path folder = host.folder().path() / "id1";
  EXPECT_TRUE(host.has_printed("Settings saved: id1/mine.cfg"));
  ASSERT_TRUE(std::filesystem::exists(folder / "old.cfg"));
  host.command("fov 90; unbind F7; exec mine.cfg; writeconfig ../../out; writeconfig /tmp/out");
  host.run(0.1);
  EXPECT_EQ(value(host, "fov"), "100");
  EXPECT_FALSE(host.host().input.bindings.find_keys("god").empty());
  EXPECT_TRUE(host.has_printed("\"../../out\" is not a valid file name"));
  EXPECT_TRUE(host.has_printed("\"/tmp/out\" is not a valid file name"));
  EXPECT_FALSE(std::filesystem::exists(folder / "../../out.cfg"));
}

// --- Several games.

constexpr std::string_view kQuick = "host_maxfps 10000\nr_threads 1\n";

void write_settings(const HeadlessHost& host, const std::string& folder, std::string_view text) {
  host.folder().write(folder + "/temblor.cfg", std::string(kQuick) + std::string(text));
}

void change_to(HeadlessHost& io_host, std::string_view game) {
  io_host.command("game " + std::string(game));
  io_host.run(0.1);
}

TEST(Settings, EachGameHasItsOwnSettings) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"sensitivity 5; sv_gravity 100; bind x \"echo first\""});
  write_settings(host, "second", "fov 120\nunbindall\nbind y \"echo second\"\n");
  change_to(host, "second");
  EXPECT_EQ(value(host, "fov"), "120");
  EXPECT_EQ(value(host, "sensitivity"), "3") << "a default, not the value of the game before";
  EXPECT_EQ(value(host, "sv_gravity"), "800");
  host.press(platform::Key{'x'});
  host.press(platform::Key{'y'});
  host.run(0.05);
  EXPECT_FALSE(host.has_printed("first"));
  EXPECT_TRUE(host.has_printed("second"));
  change_to(host, "id1");
  EXPECT_EQ(value(host, "fov"), "90");
  EXPECT_EQ(value(host, "sensitivity"), "5");
}

TEST(Settings, ANewGameStartsWithTheSettingsOfId1) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host({"sensitivity 5"});
  write_settings(host, "second", "fov 120\n");
  host.folder().write("third/readme.txt", std::string_view("nothing"));
  change_to(host, "second");
  change_to(host, "third");
  EXPECT_EQ(value(host, "sensitivity"), "5");
  EXPECT_EQ(value(host, "fov"), "90");
  host.command("sensitivity 7");
  change_to(host, "id1");
  EXPECT_EQ(value(host, "sensitivity"), "5");
  change_to(host, "third");
  EXPECT_EQ(value(host, "sensitivity"), "7");
}

TEST(Settings, CommandLineHoldsInOtherGamesUnlessThePlayerChangedIt) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host;
  write_settings(host, "id1", "");
  write_settings(host, "second", "fov 120\nsensitivity 4\n");
  host.restart(set_on_command_line);
  host.command("sensitivity 6");
  change_to(host, "second");
  EXPECT_EQ(value(host, "fov"), "110");
  EXPECT_EQ(value(host, "sensitivity"), "4");
}

// Makes a folder look read-only to the program, even if the test runs as root.
void forbid_writing(const SmallGame& game, const std::string& folder) {
  game.folder().write(folder + "/.temblor-may-write/x", std::string_view("x"));
}

TEST(Settings, GameCommandPutsModsOnAMissionPack) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost host;
  for (const char* folder : {"hipnotic", "mymod"}) write_settings(host, folder, "");
  change_to(host, "mymod -hipnotic");
  host.command("game");
  host.run(0.1);
  const auto printed_at = [&](std::string_view end) {
    return std::ranges::find_if(host.lines(), [&](const std::string& line) { return line.ends_with(end); });
  };
  ASSERT_NE(printed_at("/mymod"), host.lines().end());
  EXPECT_LT(printed_at("/hipnotic"), printed_at("/mymod")) << "the mod has priority";
}

TEST(Settings, ReadOnlyGameFoldersUseTheUserFolder) {
  const SmallGame game;
  const TemporaryFolder user;
  game.folder().write("id1/temblor.cfg", std::string_view("// came with the game"));
  game.folder().write("mod/readme.txt", std::string_view("nothing"));
  forbid_writing(game, "id1");
  user.write("id1/temblor.cfg", std::string_view("// of the player for id1"));
  user.write("id1/temblor.history", std::string_view("typed"));
  const host::GameFolders folders{game.path(), {"mod"}, user.path()};
  const auto read = [&] {
    const auto data = host::GameData::open(folders);
    EXPECT_TRUE(data.ok());
    return host::read_commands(**data, "temblor.cfg").value();
  };
  EXPECT_EQ(read(), "// of the player for id1");
  EXPECT_EQ(host::read_history(**host::GameData::open(folders)), "typed");
  game.folder().write("mod/temblor.cfg", std::string_view("// of mod"));
  EXPECT_EQ(read(), "// of mod");
  forbid_writing(game, "mod");
  EXPECT_EQ(read(), "// of mod");
  user.write("mod/temblor.cfg", std::string_view("// of the player for mod"));
  EXPECT_EQ(read(), "// of the player for mod");
}

TEST(GameData, UserFolderOverridesAReadOnlyGame) {
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

TEST(GameData, IgnoresTheUserFolderOfAWritableGame) {
  const SmallGame game;
  const TemporaryFolder user;
  user.write("id1/maps/more.bsp", std::string_view("of another id1"));
  const auto games = host::mount_games({game.path(), {}, user.path()});
  ASSERT_TRUE(games.ok());
  EXPECT_EQ(games->write_folders.back(), game.path() / "id1");
  EXPECT_FALSE(games->files.contains("maps/more.bsp"));
}

// Root may write anywhere, so permissions alone are not enough.
TEST(GameData, WritesNothingIntoAnInstalledGame) {
  const SmallGame game;
  const TemporaryFolder user;
  const auto games = host::mount_games({game.path(), {}, user.path() / "new", true});
  ASSERT_TRUE(games.ok());
  EXPECT_EQ(games->write_folders.back(), user.path() / "new/id1");
  EXPECT_TRUE(std::filesystem::is_directory(user.path() / "new/id1"));
}

}  // namespace
}  // namespace temblor::test
