// The game as a whole, without a display: levels, input, settings that are kept, pictures.
#include "host/host.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "formats/images/png.h"
#include "host/commands/host_commands.h"
#include "host/played_host.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using platform::Key;

std::size_t colors_of(const std::vector<std::uint32_t>& picture) {
  return std::set<std::uint32_t>(picture.begin(), picture.end()).size();
}

TEST(Host, PlaysALevelFromItsCommand) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(0.5);
  EXPECT_GT(colors_of(played.window().shown()), 20u);
  EXPECT_TRUE(played.window().is_mouse_captured());
  EXPECT_EQ(played.window().shown_size(), (platform::PixelSize{320, 200}));
}

TEST(Host, ALevelThatIsNotThereIsNamed) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map nowhere"});
  played.run(0.1);
  EXPECT_TRUE(played.has_printed("nowhere"));
  EXPECT_FALSE(played.host().session().is_playing());
  // And the next one is played.
  played.command("map small");
  EXPECT_TRUE(played.run_until_playing());
  played.command("map nowhere");
  played.run(0.1);
  EXPECT_TRUE(played.host().session().is_playing());
}

TEST(Host, TheViewWalksInTheFrameOfTheKey) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(1, 1.0 / 250);
  const auto eye = [&] { return played.host().data().presentation.scene().camera.origin_world; };
  const math::Vec3 before = eye();
  played.press(Key{'w'});
  played.run(1.0 / 251, 1.0 / 250);
  EXPECT_GT(glm::distance(math::Vec2(eye()), math::Vec2(before)), 1e-4f);
  played.run(0.2, 1.0 / 250);
  EXPECT_GT(glm::distance(math::Vec2(eye()), math::Vec2(before)), 10);
  EXPECT_LT(
      glm::distance(math::Vec2(eye()),
                    math::Vec2(played.host().session().server()->game()->player(0)[server::field::kOrigin])),
      10)
      << "and not far from the server's word";
}

TEST(Host, WalksWhereItsKeysSay) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(0.5);
  server::Server& server = *played.host().session().server();
  const math::Vec3 before = server.game()->player(0)[server::field::kOrigin];
  played.press(Key{'w'});
  played.run(0.3);
  played.release(Key{'w'});
  played.run(1);
  const math::Vec3 after = server.game()->player(0)[server::field::kOrigin];
  EXPECT_GT(glm::length(after - before), 30);
  const math::Vec3 velocity = server.game()->player(0)[server::field::kVelocity];
  EXPECT_LT(glm::length(math::Vec2(velocity)), 1);
}

TEST(Host, NothingSticksWhenTheFocusIsLost) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.press(Key{'w'});
  played.run(0.1);
  played.window().put(platform::FocusChanged{false});
  played.run(0.1);
  EXPECT_FALSE(played.window().is_mouse_captured());
  played.run(1);
  server::Server& server = *played.host().session().server();
  const math::Vec3 velocity = server.game()->player(0)[server::field::kVelocity];
  EXPECT_LT(glm::length(math::Vec2(velocity)), 1);
}

TEST(Host, TurnsInTheSameFrame) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(0.2);
  const std::vector<std::uint32_t> before = played.window().shown();
  const float yaw_deg = played.host().input().view_angles_deg().y;
  played.window().put(platform::MouseMoved{400, 0});
  played.run(0.001, 0.001);
  EXPECT_NEAR(played.host().input().view_angles_deg().y, yaw_deg - 26.4f, 0.01);
  EXPECT_NE(played.window().shown(), before);
}

// Whether the game goes on beside the drawing or before it, it comes to the same.
TEST(Host, TwoHalvesAtOnceGiveTheSameGame) {
  SKIP_WITHOUT_QUAKEC();
  std::vector<std::vector<std::uint32_t>> pictures;
  std::vector<math::Vec3> places;
  for (const char* const parallel : {"host_parallel 0", "host_parallel 1"}) {
    PlayedHost played({parallel, "map small"});
    ASSERT_TRUE(played.run_until_playing());
    played.press(Key{'w'});
    played.run(0.4);
    played.window().put(platform::MouseMoved{200, 10});
    played.run(0.4);
    pictures.push_back(played.window().shown());
    places.push_back(played.host().session().server()->game()->player(0)[server::field::kOrigin]);
  }
  EXPECT_EQ(places[0], places[1]);
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(Host, KeepsSettingsAndBindingsOverARestart) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"bind x \"echo hello\"; sensitivity 7.5; fov 105; unbind w; sv_gravity 100"});
  played.command("quit");
  played.run(0.1);
  played.start_again();
  const command::Variables& variables = played.variables().variables();
  EXPECT_EQ(variables.find("sensitivity")->number, 7.5);
  EXPECT_EQ(variables.find("fov")->number, 105);
  EXPECT_EQ(variables.find("sv_gravity")->number, 800) << "a server's rules are not the player's settings";
  played.press(Key{'x'});
  played.run(0.05);
  EXPECT_TRUE(played.has_printed("hello"));
  played.command("bind w");
  played.run(0.05);
  EXPECT_TRUE(played.has_printed("\"w\" does nothing"));
}

TEST(Host, AConfigurationThatIsNoTextIsKeptAside) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played;
  played.folder().write("id1/temblor.cfg", std::string_view("sensitivity 9\n\0\x01\x02 rubbish", 25));
  played.start_again();
  played.run(0.05);
  EXPECT_TRUE(played.has_printed("In temblor.cfg 1 line could not be read"));
  EXPECT_EQ(played.variables().variables().find("sensitivity")->number, 9) << "the line above is good";
  EXPECT_TRUE(std::filesystem::exists(played.folder().path() / "id1/temblor.cfg.damaged"));
  played.command("quit");
  played.run(0.05);
  played.start_again();
  played.run(0.05);
  EXPECT_FALSE(played.has_printed("could not be read")) << "it was written anew";
  EXPECT_EQ(played.variables().variables().find("sensitivity")->number, 9);
}

// What is text and means nothing here: the player's, and not to be lost either.
TEST(Host, LinesOfTheConfigurationThatMeanNothingAreKeptAside) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played;
  played.folder().write(
      "id1/temblor.cfg",
      std::string_view("sensitivity 9\nfov wide\nno_such_thing 1\nbind x \"echo hello\"\n"));
  played.start_again();
  played.run(0.05);
  EXPECT_TRUE(played.has_printed("In temblor.cfg 2 lines could not be read"));
  EXPECT_TRUE(played.has_printed("temblor.cfg:2: "));
  EXPECT_TRUE(played.has_printed("temblor.cfg:3: "));
  EXPECT_TRUE(std::filesystem::exists(played.folder().path() / "id1/temblor.cfg.damaged"));
  EXPECT_EQ(played.variables().variables().find("sensitivity")->number, 9);
}

TEST(Host, TellsWhereThePlayerLooksFrom) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"viewpos", "map small"});
  ASSERT_TRUE(played.run_until_playing());
  EXPECT_TRUE(played.has_printed("viewpos: there is no view"));
  played.run(0.5);
  played.command("viewpos");
  played.run(0.05);
  const math::Vec3 origin = played.host().session().server()->game()->player(0)[server::field::kOrigin];
  EXPECT_TRUE(played.has_printed(
      fmt::format("eyes at {:.0f} {:.0f} {:.0f} (units)", origin.x, origin.y, origin.z + 22)));
}

TEST(Host, AGameThatIsSavedByItselfGetsItsPicture) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(7);
  EXPECT_TRUE(played.has_printed("saved as autosave"));
  for (const char* file : {"id1/autosave.sav", "id1/autosave.png"})
    EXPECT_TRUE(std::filesystem::exists(played.folder().path() / file)) << file;
  EXPECT_EQ(played.host().unsaved(), "") << "it is saved when it is left";
  played.command("sv_autosave 0");
  played.run(6);
  EXPECT_NE(played.host().unsaved(), "");
}

TEST(Host, CommandsThatCallThemselvesEnd) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"alias loop loop", "bind l loop", "map small"});
  played.folder().write("id1/again.cfg", std::string_view("exec again.cfg\n"));
  ASSERT_TRUE(played.run_until_playing());
  played.press(Key{'l'});
  played.run(0.05);
  EXPECT_TRUE(played.has_printed("must call itself"));
  played.command("exec again.cfg");
  played.run(0.05);
  played.command(std::string(3u << 20, 'x'));
  played.run(0.05);
  EXPECT_TRUE(played.has_printed("too many commands"));
  EXPECT_TRUE(played.host().session().is_playing());
}

TEST(Host, ScreenshotIsWhatIsShown) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(0.2);
  const std::vector<std::uint32_t> shown = played.window().shown();
  played.command("screenshot shot");
  played.run(0.01, 0.01);
  const base::ByteVector png = read_file(played.folder().path() / "id1/shot.png");
  const auto image = formats::read_png(png);
  ASSERT_TRUE(image.ok());
  ASSERT_EQ(image->pixels.size(), shown.size());
  EXPECT_EQ(image->pixels, shown);
}

TEST(Host, WindowsOfAnySizeAreDrawn) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  for (const platform::PixelSize size :
       {platform::PixelSize{1, 1}, {1, 300}, {300, 1}, {16384, 2}, {640, 480}}) {
    ASSERT_TRUE(played.window().apply({.size = size}).ok());
    played.run(0.03);
    const platform::PixelSize shown = played.window().shown_size();
    EXPECT_EQ(shown.width, std::min(size.width, host::Screen::kLargest));
    EXPECT_EQ(shown.height, size.height);
    EXPECT_EQ(played.variables().window().size, size) << "how large the player has pulled it is kept";
  }
}

TEST(Host, PaletteAndTrueColorShowTheSameScene) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"viewsize 120; con_notifylines 0", "map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(1.5);  // until the console has gone
  const std::vector<std::uint32_t> rgb = played.window().shown();
  played.command("vid_color indexed");
  played.run(0.01, 0.01);
  const std::vector<std::uint32_t> indexed = played.window().shown();
  ASSERT_EQ(rgb.size(), indexed.size());
  double difference = 0;
  for (std::size_t i = 0; i < rgb.size(); ++i)
    for (const int shift : {0, 8, 16})
      difference +=
          std::abs(static_cast<int>(rgb[i] >> shift & 255) - static_cast<int>(indexed[i] >> shift & 255));
  EXPECT_LT(difference / static_cast<double>(rgb.size() * 3), 16);
  played.command("gamma 0.5");
  played.run(0.01, 0.01);
  double before = 0, after = 0;
  for (const std::uint32_t pixel : indexed) before += pixel >> 8 & 255;
  for (const std::uint32_t pixel : played.window().shown()) after += pixel >> 8 & 255;
  EXPECT_GT(after, before * 1.2);
}

TEST(Host, SavesAndLoads) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(0.3);
  server::Server& server = *played.host().session().server();
  const math::Vec3 saved = server.game()->player(0)[server::field::kOrigin];
  played.command("save here");
  played.press(Key{'w'});
  played.run(0.4);
  played.release(Key{'w'});
  played.run(0.1);
  played.command("load here");
  played.run(1);
  ASSERT_TRUE(played.host().session().is_playing());
  const math::Vec3 loaded = played.host().session().server()->game()->player(0)[server::field::kOrigin];
  EXPECT_LT(glm::length(loaded - saved), 2);
}

// The server stands still, and nobody gives it up for that.
TEST(Host, APauseMayLastAnHour) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.run(0.2);
  const double before_s = played.host().session().server()->game()->time_s();
  played.press(Key::kEscape);
  played.run(3600, 10);
  EXPECT_TRUE(played.host().session().is_playing());
  EXPECT_NEAR(played.host().session().server()->game()->time_s(), before_s, 0.1);
  played.press(Key::kEscape);
  played.run(0.5);
  EXPECT_TRUE(played.host().session().is_playing());
  EXPECT_GT(played.host().session().server()->game()->time_s(), before_s + 0.2);
}

TEST(Host, TheConsoleOpensOverTheMenu) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  played.press(Key::kEscape);
  played.run(0.1);
  EXPECT_FALSE(played.host().console_ui().takes_text());
  played.press(Key{'`'});
  played.run(0.1);
  EXPECT_TRUE(played.host().console_ui().takes_text());
  played.press(Key::kEscape);
  played.press(Key{'`'});
  played.run(0.1);
  EXPECT_TRUE(played.host().console_ui().takes_text()) << "the menu was closed when it opened";
}

TEST(Host, AMistypedLevelOrSaveEndsNothing) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  for (const char* const line : {"map nowhere", "load nothing"}) {
    played.command(line);
    played.run(0.1);
    EXPECT_TRUE(played.host().session().is_playing()) << line;
  }
  EXPECT_TRUE(played.has_printed("there is no level \"nowhere\""));
  EXPECT_TRUE(played.has_printed("there is no saved game \"nothing\""));
}

TEST(Host, LeavesAndComesBack) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(played.run_until_playing()) << i;
    played.command("disconnect");
    played.run(0.05);
    EXPECT_FALSE(played.host().session().is_playing());
    EXPECT_FALSE(played.window().is_mouse_captured());
    played.command("map small");
  }
}

TEST(Host, AWindowThatIsLostIsToldOnceEachTime) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"map small"});
  ASSERT_TRUE(played.run_until_playing());
  const auto told = [&] {
    return std::count_if(played.lines().begin(), played.lines().end(),
                         [](const std::string& line) { return line.find("window is lost") != line.npos; });
  };
  played.window().set_can_present(false);
  played.run(0.5);
  EXPECT_EQ(told(), 1);
  EXPECT_TRUE(played.host().session().is_playing());
  played.window().set_can_present(true);
  played.run(0.1);
  played.window().set_can_present(false);
  played.run(0.1);
  EXPECT_EQ(told(), 2);
}

TEST(Host, WhatAForeignServerMayHaveRunHere) {
  EXPECT_TRUE(host::may_be_stuffed("play misc/hello.wav"));
  EXPECT_FALSE(host::may_be_stuffed("play x; quit"));
  EXPECT_FALSE(host::may_be_stuffed("bind w quit"));
  EXPECT_FALSE(host::may_be_stuffed("exec evil.cfg"));
  EXPECT_FALSE(host::may_be_stuffed(""));
}

}  // namespace
}  // namespace temblor::test
