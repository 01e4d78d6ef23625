// A complete game without a display: levels, input, saved settings, pictures.
#include "host/host.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "formats/images/png.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "host/session/games.h"
#include "lab/registry.h"
#include "platform/posix/udp_socket.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using platform::Key;

std::size_t count_colors(const std::vector<std::uint32_t>& picture) {
  return std::set<std::uint32_t>(picture.begin(), picture.end()).size();
}

TEST(Host, MapCommandStartsALevel) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.5);
  EXPECT_GT(count_colors(game.window().shown()), 20u);
  EXPECT_TRUE(game.window().is_mouse_captured());
  EXPECT_EQ(game.window().shown_size(), (platform::PixelSize{320, 200}));
}

TEST(Host, ReportsAMissingLevelAndPlaysTheNext) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map nowhere"});
  game.run(0.1);
  EXPECT_TRUE(game.has_printed("nowhere"));
  EXPECT_FALSE(game.session().is_playing());
  game.command("map small");
  EXPECT_TRUE(game.run_until_playing());
  game.command("map nowhere");
  game.run(0.1);
  EXPECT_TRUE(game.session().is_playing());
}

TEST(Host, PredictsMovementInTheFrameOfTheKeyPress) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(1, 1.0 / 250);
  const auto eye = [&] { return game.host().game.data->presentation.scene().camera.origin_world; };
  const math::Vec3 before = eye();
  game.press(Key{'w'});
  game.run(1.0 / 251, 1.0 / 250);
  EXPECT_GT(glm::distance(math::Vec2(eye()), math::Vec2(before)), 1e-4f);
  game.run(0.2, 1.0 / 250);
  EXPECT_GT(glm::distance(math::Vec2(eye()), math::Vec2(before)), 10);
  EXPECT_LT(glm::distance(math::Vec2(eye()),
                          math::Vec2(game.session().server()->game->player(0)[server::field::kOrigin])),
            10)
      << "and close to the position on the server";
}

TEST(Host, KeysMoveThePlayer) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.5);
  server::Server& server = *game.session().server();
  const math::Vec3 before = server.game->player(0)[server::field::kOrigin];
  game.press(Key{'w'});
  game.run(0.3);
  game.release(Key{'w'});
  game.run(1);
  const math::Vec3 after = server.game->player(0)[server::field::kOrigin];
  EXPECT_GT(glm::length(after - before), 30);
  const math::Vec3 velocity = server.game->player(0)[server::field::kVelocity];
  EXPECT_LT(glm::length(math::Vec2(velocity)), 1);
}

// The tick of the first frame after the key already moves the player, at its full acceleration.
TEST(Host, AKeyReachesThePhysicsInItsFrame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small", "host_parallel 0"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.5);
  const auto speed = [&] {
    return glm::length(math::Vec2(game.session().server()->game->player(0)[server::field::kVelocity]));
  };
  for (const bool is_typed : {false, true}) {
    ASSERT_LT(speed(), 1e-3f);
    is_typed ? game.command("+forward") : game.press(Key{'w'});
    game.run(1.0 / 72 - 1e-9);
    // 10 sv_accelerate * 320 sv_maxspeed / 72, without friction because the player stood.
    EXPECT_NEAR(speed(), 320 * 10 / 72.0f, 0.5f) << is_typed;
    is_typed ? game.command("-forward") : game.release(Key{'w'});
    game.run(1);
  }
}

TEST(Host, ReleasesKeysWhenFocusIsLost) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.press(Key{'w'});
  game.run(0.1);
  game.window().put(platform::FocusChanged{false});
  game.run(0.1);
  EXPECT_FALSE(game.window().is_mouse_captured());
  game.window().put(platform::FocusChanged{true});
  game.run(1);
  server::Server& server = *game.session().server();
  const math::Vec3 velocity = server.game->player(0)[server::field::kVelocity];
  EXPECT_LT(glm::length(math::Vec2(velocity)), 1);
}

TEST(Host, RunsCommandsOnceThePlayerIsInTheGame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  game.host().options.commands_in_game = {"god; echo done"};
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.5);
  EXPECT_TRUE(game.has_printed("godmode ON"));
  EXPECT_FALSE(game.has_printed("god: "));
  game.command("god; map small");
  game.run(1);
  ASSERT_TRUE(game.run_until_playing());
  EXPECT_EQ(std::count(game.lines().begin(), game.lines().end(), "done"), 1);
}

TEST(Host, ListsLevelsInPlayOrder) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  for (const char* name : {"gallery", "dm1", "e1m2", "e1m10", "e2m1", "end", "start", "b_box", "tdm2"})
    game.folder().write(fmt::format("id1/maps/{}.bsp", name), std::string_view("not read"));
  game.restart();
  std::vector<std::string> names;
  for (const client::MenuLevel& level : game.host().game.menu_lists->content().levels())
    names.push_back(level.name);
  const std::vector<std::string> expected = {"start", "e1m2", "e1m10",   "e2m1", "end",
                                             "dm1",   "tdm2", "gallery", "small"};
  EXPECT_EQ(names, expected);
}

TEST(Host, RestoresTheDefaultKeysOfTheGame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/default.cfg", std::string_view("bind 9 \"impulse 13\"\nsensitivity 7\n"));
  game.restart();
  game.command("unbindall; sensitivity 4; bind_defaults");
  game.run(0.1);
  EXPECT_FALSE(game.host().input.bindings.find_keys("impulse 13").empty());
  EXPECT_FALSE(game.host().input.bindings.find_keys("+forward").empty());
  EXPECT_EQ(game.variables().variables().find("sensitivity")->number, 4);
}

TEST(Host, MouseTurnsTheViewInTheSameFrame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.2);
  const std::vector<std::uint32_t> before = game.window().shown();
  const float yaw_deg = game.host().input.player.view_angles_deg().y;
  game.window().put(platform::MouseMoved{400, 0});
  game.run(0.001, 0.001);
  EXPECT_NEAR(game.host().input.player.view_angles_deg().y, yaw_deg - 26.4f, 0.01);
  EXPECT_NE(game.window().shown(), before);
}

// Running ticks in parallel with drawing must not change the game or the picture.
TEST(Host, ParallelTicksGiveTheSameGame) {
  SKIP_WITHOUT_QUAKEC();
  std::vector<std::vector<std::uint32_t>> pictures;
  std::vector<math::Vec3> places;
  for (const char* const parallel : {"host_parallel 0", "host_parallel 1"}) {
    HeadlessHost game({parallel, "map small"});
    ASSERT_TRUE(game.run_until_playing());
    game.press(Key{'w'});
    game.run(0.4);
    game.window().put(platform::MouseMoved{200, 10});
    game.run(0.4);
    pictures.push_back(game.window().shown());
    places.push_back(game.session().server()->game->player(0)[server::field::kOrigin]);
  }
  EXPECT_EQ(places[0], places[1]);
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(Host, SavesSettingsAndBindings) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"bind x \"echo hello\"; sensitivity 7.5; fov 105; unbind w; sv_gravity 100"});
  game.command("quit");
  game.run(0.1);
  game.restart();
  const command::Variables& variables = game.variables().variables();
  EXPECT_EQ(variables.find("sensitivity")->number, 7.5);
  EXPECT_EQ(variables.find("fov")->number, 105);
  EXPECT_EQ(variables.find("sv_gravity")->number, 800)
      << "server rules are not saved with the player's settings";
  game.press(Key{'x'});
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("hello"));
  game.command("bind w");
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("\"w\" is not bound"));
}

TEST(Host, CopiesAConfigurationWithBinaryData) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/temblor.cfg", std::string_view("sensitivity 9\n\0\x01\x02 rubbish", 25));
  game.restart();
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("1 line of temblor.cfg could not be read"));
  EXPECT_EQ(game.variables().variables().find("sensitivity")->number, 9)
      << "lines before the damage are read";
  EXPECT_TRUE(std::filesystem::exists(game.folder().path() / "id1/temblor.cfg.damaged"));
  game.command("quit");
  game.run(0.05);
  game.restart();
  game.run(0.05);
  EXPECT_FALSE(game.has_printed("could not be read")) << "the file was rewritten";
  EXPECT_EQ(game.variables().variables().find("sensitivity")->number, 9);
}

// Commands that the program does not know still belong to the player and must not be lost.
TEST(Host, CopiesAConfigurationWithUnknownCommands) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/temblor.cfg",
                      std::string_view("sensitivity 9\nfov wide\nno_such_thing 1\nbind x \"echo hello\"\n"));
  game.restart();
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("2 lines of temblor.cfg could not be read"));
  EXPECT_TRUE(game.has_printed("temblor.cfg:2: "));
  EXPECT_TRUE(game.has_printed("temblor.cfg:3: "));
  EXPECT_TRUE(std::filesystem::exists(game.folder().path() / "id1/temblor.cfg.damaged"));
  EXPECT_EQ(game.variables().variables().find("sensitivity")->number, 9);
}

TEST(Host, ViewposPrintsTheCamera) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"viewpos", "map small"});
  ASSERT_TRUE(game.run_until_playing());
  EXPECT_TRUE(game.has_printed("viewpos: start or join a game first"));
  game.run(0.5);
  game.command("viewpos");
  game.run(0.05);
  const math::Vec3 origin = game.session().server()->game->player(0)[server::field::kOrigin];
  EXPECT_TRUE(game.has_printed(
      fmt::format("position {:.0f} {:.0f} {:.0f} (map units)", origin.x, origin.y, origin.z + 22)));
}

TEST(Host, AutosaveWritesAPicture) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(7);
  EXPECT_TRUE(game.has_printed("Autosaved"));
  for (const char* file : {"id1/autosave.sav", "id1/autosave.png"})
    EXPECT_TRUE(std::filesystem::exists(game.folder().path() / file)) << file;
  EXPECT_EQ(host::find_unsaved_progress(game.host()), "") << "leaving the game saves it";
  game.command("sv_autosave 0");
  game.run(6);
  EXPECT_NE(host::find_unsaved_progress(game.host()), "");
}

TEST(Host, RecursiveCommandsEnd) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"alias loop loop", "bind l loop", "map small"});
  game.folder().write("id1/again.cfg", std::string_view("exec again.cfg\n"));
  ASSERT_TRUE(game.run_until_playing());
  game.press(Key{'l'});
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("call itself"));
  game.command("exec again.cfg");
  game.run(0.05);
  game.command(std::string(3u << 20, 'x'));
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("too many pending commands"));
  EXPECT_TRUE(game.session().is_playing());
}

TEST(Host, ScreenshotMatchesTheWindow) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.2);
  const std::vector<std::uint32_t> shown = game.window().shown();
  game.command("screenshot shot");
  game.run(0.01, 0.01);
  const base::ByteVector png = read_file(game.folder().path() / "id1/shot.png");
  const auto image = formats::read_png(png);
  ASSERT_TRUE(image.ok());
  ASSERT_EQ(image->pixels.size(), shown.size());
  EXPECT_EQ(image->pixels, shown);
}

TEST(Host, DrawsByATechniqueOfTheLaboratory) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.2);
  const auto technique = [&] { return lab::list_techniques()[game.host().game.data->technique].name; };
  EXPECT_EQ(technique(), "bsp-edges");
  game.command("r_technique painter");
  game.run(0.1);
  EXPECT_EQ(technique(), "painter");
  EXPECT_GT(count_colors(game.window().shown()), 50u);
  game.command("r_technique photons");
  game.run(0.1);
  EXPECT_TRUE(game.has_printed("intersecting-edges")) << "names the valid values";
  EXPECT_EQ(technique(), "painter");
  game.command("r_technique portals");
  game.run(0.1);
  EXPECT_EQ(technique(), "portals");
  game.command("r_technique bsp-edges");
  game.run(0.1);
  EXPECT_EQ(technique(), "bsp-edges");
}

TEST(Host, ScreenshotsNeverReplaceOthers) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  // One empty file with many names is quicker to make than as many files.
  const std::filesystem::path first = game.folder().write("id1/temblor0000.png", std::string_view());
  for (int number = 1; number < 10000; ++number)
    if (number != 9998)
      std::filesystem::create_hard_link(first, first.parent_path() / fmt::format("temblor{:04}.png", number));
  game.command("screenshot");
  game.run(0.02, 0.01);
  EXPECT_GT(std::filesystem::file_size(game.folder().path() / "id1/temblor9998.png"), 0u);
  game.command("screenshot");
  game.run(0.02, 0.01);
  EXPECT_TRUE(game.has_printed("has 10000 of them"));
  EXPECT_EQ(std::filesystem::file_size(game.folder().path() / "id1/temblor9999.png"), 0u);
}

TEST(Host, ListsModsWhoseFilesAreInCapitals) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("OLDMOD/PAK0.PAK", std::string_view());
  game.folder().write("maponly/Maps/x.bsp", std::string_view());
  game.folder().write("docs/readme.txt", std::string_view());
  std::vector<std::string> names;
  for (const client::MenuGameFolder& folder : game.host().game.menu_lists->game_folders())
    names.push_back(folder.name);
  EXPECT_THAT(names, testing::ElementsAre("OLDMOD", "id1", "maponly"));
}

TEST(Host, AnUnknownLanguageNamesTheKnownOnes) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  for (const char* const language : {"english", "german"})
    game.folder().write(fmt::format("id1/localization/loc_{}.txt", language),
                        std::string_view("a = \"x\"\n"));
  game.restart(nullptr, {});
  game.run(0.1);
  game.command("language german");
  game.run(0.1);
  EXPECT_FALSE(game.has_printed("there is no language"));
  game.command("language klingon");
  game.run(0.1);
  EXPECT_TRUE(game.has_printed("there is no language \"klingon\" here, only english, german"));
}

TEST(Host, FaultsOfTextsAreNamedAtTheStart) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/localization/loc_english.txt", std::string_view("a = \"x\"\nb = \"y\n"));
  game.restart(nullptr, {"map small"});
  ASSERT_TRUE(game.run_until_playing());
  EXPECT_TRUE(game.has_printed("loc_english.txt: line 2: "));
}

TEST(Host, FaultsOfEntitiesNameTheirFile) {
  SKIP_WITHOUT_QUAKEC();
  const std::string entities =
      "{ \"classname\" \"worldspawn\" }\n{ \"classname\" \"info_player_start\" \"origin\" \"64 128 40\" }\n";
  HeadlessHost game;
  game.folder().write("id1/maps/small.ent", entities + "{ \"classname\" \"func_nonesuch\" }\n");
  game.restart(nullptr, {"map small"});
  ASSERT_TRUE(game.run_until_playing());
  EXPECT_TRUE(game.has_printed("small.ent: entity 2 at 0 0 0: there is no function"));
  // More text than the game code's strings can hold.
  game.folder().write("id1/maps/small.ent",
                      entities + "{ \"classname\" \"" + std::string(std::size_t{65} << 20, 'x') + "\" }\n");
  game.command("map small");
  game.run(0.2);
  EXPECT_TRUE(game.has_printed("small: entity 2: out of string memory"));
  EXPECT_TRUE(game.session().is_playing()) << "the running game goes on";
}

TEST(Host, DrawsWindowsOfAnySize) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  for (const platform::PixelSize size :
       {platform::PixelSize{1, 1}, {1, 300}, {300, 1}, {16384, 2}, {640, 480}}) {
    ASSERT_TRUE(game.window().apply({.size = size}).ok());
    game.run(0.03);
    const platform::PixelSize shown = game.window().shown_size();
    EXPECT_EQ(shown.width, std::min(size.width, host::Screen::kMaxSize));
    EXPECT_EQ(shown.height, size.height);
    EXPECT_EQ(game.variables().window().size, size) << "the new size is saved";
  }
}

TEST(Host, PaletteAndTrueColorShowTheSameScene) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"viewsize 120; con_notifylines 0", "map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(1.5);  // until the console has closed
  const std::vector<std::uint32_t> rgb = game.window().shown();
  game.command("vid_color indexed");
  game.run(0.01, 0.01);
  const std::vector<std::uint32_t> indexed = game.window().shown();
  ASSERT_EQ(rgb.size(), indexed.size());
  double difference = 0;
  for (std::size_t i = 0; i < rgb.size(); ++i)
    for (const int shift : {0, 8, 16})
      difference +=
          std::abs(static_cast<int>(rgb[i] >> shift & 255) - static_cast<int>(indexed[i] >> shift & 255));
  EXPECT_LT(difference / static_cast<double>(rgb.size() * 3), 16);
  game.command("gamma 0.5");
  game.run(0.01, 0.01);
  double before = 0, after = 0;
  for (const std::uint32_t pixel : indexed) before += pixel >> 8 & 255;
  for (const std::uint32_t pixel : game.window().shown()) after += pixel >> 8 & 255;
  EXPECT_GT(after, before * 1.2);
}

TEST(Host, SavesAndLoads) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.3);
  server::Server& server = *game.session().server();
  const math::Vec3 saved = server.game->player(0)[server::field::kOrigin];
  game.command("save here");
  game.press(Key{'w'});
  game.run(0.4);
  game.release(Key{'w'});
  game.run(0.1);
  game.command("load here");
  game.run(1);
  ASSERT_TRUE(game.session().is_playing());
  const math::Vec3 loaded = game.session().server()->game->player(0)[server::field::kOrigin];
  EXPECT_LT(glm::length(loaded - saved), 2);
}

// The server stands still, and the connection does not time out.
TEST(Host, SurvivesAPauseOfAnHour) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.2);
  const double before_s = game.session().server()->game->time_s();
  game.press(Key::kEscape);
  game.run(3600, 10);
  EXPECT_TRUE(game.session().is_playing());
  EXPECT_NEAR(game.session().server()->game->time_s(), before_s, 0.1);
  game.press(Key::kEscape);
  game.run(0.5);
  EXPECT_TRUE(game.session().is_playing());
  EXPECT_GT(game.session().server()->game->time_s(), before_s + 0.2);
}

TEST(Host, ConsoleKeyWorksInTheMenu) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.press(Key::kEscape);
  game.run(0.1);
  EXPECT_FALSE(game.host().console.ui.takes_text());
  game.press(Key{'`'});
  game.run(0.1);
  EXPECT_TRUE(game.host().console.ui.takes_text());
  game.press(Key::kEscape);
  game.press(Key{'`'});
  game.run(0.1);
  EXPECT_TRUE(game.host().console.ui.takes_text()) << "the menu closed when the console opened";
}

TEST(Host, MistypedNamesDoNotEndTheGame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  for (const char* const line : {"map nowhere", "load nothing"}) {
    game.command(line);
    game.run(0.1);
    EXPECT_TRUE(game.session().is_playing()) << line;
  }
  EXPECT_TRUE(game.has_printed("No level \"nowhere\""));
  EXPECT_TRUE(game.has_printed("No saved game \"nothing\""));
}

TEST(Host, DisconnectsAndStartsAgain) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(game.run_until_playing()) << i;
    game.command("disconnect");
    game.run(0.05);
    EXPECT_FALSE(game.session().is_playing());
    EXPECT_FALSE(game.window().is_mouse_captured());
    game.command("map small");
  }
}

TEST(Host, ReportsALostWindowOnceEachTime) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  const auto count_reports = [&] {
    return std::count_if(game.lines().begin(), game.lines().end(),
                         [](const std::string& line) { return line.find("window is lost") != line.npos; });
  };
  game.window().set_can_present(false);
  game.run(0.5);
  EXPECT_EQ(count_reports(), 1);
  EXPECT_TRUE(game.session().is_playing());
  game.window().set_can_present(true);
  game.run(0.1);
  game.window().set_can_present(false);
  game.run(0.1);
  EXPECT_EQ(count_reports(), 2);
}

// The clock of the first frame counts, although nothing was read from the network before.
TEST(Host, AsksAServerOnceAtATime) {
  SKIP_WITHOUT_QUAKEC();
  const auto server = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  ASSERT_TRUE(server.ok());
  HeadlessHost game;
  game.restart(nullptr, {fmt::format("connect 127.0.0.1:{}", (*server)->local_address().port)});
  game.host().services.look_up = platform::posix::look_up;
  game.host().services.open_socket = [](std::uint16_t) {
    return platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  };
  game.run(0.1);
  EXPECT_TRUE((*server)->receive().has_value());
  EXPECT_FALSE((*server)->receive().has_value());
}

}  // namespace
}  // namespace temblor::test
