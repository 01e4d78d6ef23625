// Demos in a complete game: playing, controls, attract mode, recording.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "client/demo/demo_session.h"
#include "formats/game/dem.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "host/session/session.h"
#include "platform/posix/udp_socket.h"
#include "server/session/stages.h"
#include "support/generated_demo.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using platform::Key;

// A host with the generated demo "made".
class DemoHost : public HeadlessHost {
 public:
  explicit DemoHost(const std::vector<std::string>& commands) {
    folder().write("id1/made.dem", make_recording({}).bytes);
    for (const std::string& line : commands) command(line);
    run(0.1);
  }
};

double demo_second(HeadlessHost& io_host) {
  return io_host.demo()->time_s() - io_host.demo()->begin_s();
}

void tap(HeadlessHost& io_host, Key key) {
  io_host.press(key);
  io_host.release(key);
  io_host.run(0.02);
}

TEST(HostDemos, KeysControlPlayback) {
  SKIP_WITHOUT_QUAKEC();
  DemoHost game({"playdemo made"});
  ASSERT_NE(game.demo(), nullptr);
  game.run(2);
  EXPECT_NEAR(demo_second(game), 2.1, 0.1);
  tap(game, Key::kSpace);
  const double paused_at = demo_second(game);
  game.run(1);
  EXPECT_EQ(demo_second(game), paused_at);
  tap(game, Key::kRightArrow);
  EXPECT_NEAR(demo_second(game), paused_at + 5, 1e-6);
  tap(game, Key{'.'});
  EXPECT_GT(demo_second(game), paused_at + 5);
  tap(game, Key::kHome);
  EXPECT_EQ(demo_second(game), 0);
  tap(game, Key::kSpace);
  tap(game, Key::kUpArrow);
  EXPECT_EQ(game.demo()->speed(), 2);
  game.run(9);
  EXPECT_EQ(game.demo(), nullptr) << "the demo has ended";
}

TEST(HostDemos, CommandsSeekAndSetTheSpeed) {
  SKIP_WITHOUT_QUAKEC();
  DemoHost game({"playdemo made", "demo_pause", "demo_seek 7", "demo_speed 0.5"});
  EXPECT_NEAR(demo_second(game), 7, 1e-6);
  game.command("demo_seek +2");
  game.run(0.1);
  EXPECT_NEAR(demo_second(game), 9, 1e-6);
  game.command("stopdemo; demo_seek 1");
  game.run(0.1);
  EXPECT_EQ(game.demo(), nullptr);
}

// Each text is printed only once, although the demo is scanned before it plays.
TEST(HostDemos, PrintsRecordedTextOnce) {
  SKIP_WITHOUT_QUAKEC();
  formats::DemWriter writer;
  HeadlessHost game;
  base::ByteVector bytes = make_recording({}).bytes;
  formats::DemReader whole = formats::DemReader::open(bytes).value();
  int record_number = 0;
  for (auto record = whole.next().value(); record; record = whole.next().value()) {
    base::ByteVector message(record->message.begin(), record->message.end());
    if (++record_number == 40) {
      base::ByteWriter print;
      print.u8(8);  // svc_print
      print.bytes(base::as_bytes(std::string_view("good morning\n\0", 14)));
      message.insert(message.end(), print.view().begin(), print.view().end());
    }
    writer.add(record->view_angles_deg, message);
  }
  game.folder().write("id1/talk.dem", std::move(writer).take());
  game.command("playdemo talk");
  game.run(4);
  EXPECT_EQ(std::count(game.lines().begin(), game.lines().end(), "good morning"), 1);
}

TEST(HostDemos, TimedemoPrintsTheFrameRate) {
  SKIP_WITHOUT_QUAKEC();
  DemoHost game({"timedemo made"});
  game.run(10);
  EXPECT_EQ(game.demo(), nullptr);
  EXPECT_TRUE(game.has_printed(" fps"));
}

TEST(HostDemos, ReportsMissingAndDamagedDemos) {
  SKIP_WITHOUT_QUAKEC();
  DemoHost game({"playdemo nothing"});
  EXPECT_TRUE(game.has_printed("nothing.dem"));
  base::ByteVector bytes = make_recording({}).bytes;
  std::fill(bytes.begin() + 3000, bytes.end(), std::byte{0xee});
  game.folder().write("id1/damaged.dem", bytes);
  game.command("playdemo damaged");
  game.run(0.1);
  EXPECT_NE(game.demo(), nullptr) << "the intact part is shown";
  EXPECT_FALSE(game.has_printed("damaged.dem: "));
  game.run(20);
  EXPECT_TRUE(game.has_printed("damaged.dem: "));
  EXPECT_EQ(game.demo(), nullptr);
}

TEST(HostDemos, AttractModePlaysDemosInALoop) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/first.dem", make_recording({}).bytes);
  game.folder().write("id1/broken.dem", std::string_view("not a demo"));
  game.folder().write("id1/second.dem", make_recording({}).bytes);
  game.folder().write("id1/quake.rc", std::string_view("exec default.cfg\nstartdemos first broken second\n"));
  game.restart();
  game.run(1);
  ASSERT_NE(game.demo(), nullptr) << "behind the menu";
  constexpr double kFrame_s = 0.05;
  const double length_s = game.demo()->end_s() - game.demo()->begin_s();
  game.run(length_s, kFrame_s);
  ASSERT_NE(game.demo(), nullptr);
  EXPECT_LT(demo_second(game), 2) << "the second one";
  EXPECT_TRUE(game.has_printed("broken.dem"));
  game.run(length_s, kFrame_s);
  ASSERT_NE(game.demo(), nullptr) << "the first again";
  tap(game, Key::kEscape);
  const double before_s = demo_second(game);
  tap(game, Key::kRightArrow);
  EXPECT_LT(demo_second(game), before_s + 1) << "demo controls are off in attract mode";
  game.command("map small");
  ASSERT_TRUE(game.run_until_playing());
  EXPECT_EQ(game.demo(), nullptr);
  game.run(1);
  EXPECT_EQ(game.demo(), nullptr);
}

TEST(HostDemos, NoKeyQuitsInAttractMode) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/demo1.dem", make_recording({}).bytes);
  game.folder().write("id1/quake.rc", std::string_view("exec default.cfg\nstartdemos demo1\n"));
  for (const Key key : {Key::kF10, Key{'y'}, Key::kEscape, Key::kF6, Key::kSpace}) {
    game.restart();
    game.run(0.5);
    ASSERT_NE(game.demo(), nullptr);
    tap(game, Key::kEscape);
    ASSERT_FALSE(game.host().game.menu->is_open());
    tap(game, key);
    EXPECT_FALSE(game.host().wants_to_quit);
    EXPECT_TRUE(game.host().game.menu->is_open());
  }
}

TEST(HostDemos, TheMenuStopsADemo) {
  SKIP_WITHOUT_QUAKEC();
  DemoHost game({"playdemo made"});
  ASSERT_NE(game.demo(), nullptr);
  tap(game, Key::kEscape);
  ASSERT_TRUE(game.host().game.menu->is_open());
  // From the first row: the row before "Quit" is the last but one.
  tap(game, Key::kUpArrow);
  tap(game, Key::kUpArrow);
  tap(game, Key::kEnter);
  game.run(0.1);
  EXPECT_EQ(game.demo(), nullptr);
  EXPECT_TRUE(game.host().game.menu->is_open());
}

TEST(HostDemos, AttractModeReturnsBehindTheMenuAfterAGame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/demo1.dem", make_recording({}).bytes);
  game.restart(nullptr, {"map small"});
  ASSERT_TRUE(game.run_until_playing());
  tap(game, Key::kEscape);
  game.run(0.1);
  EXPECT_EQ(game.demo(), nullptr) << "the game goes on behind the menu";
  game.command("disconnect");
  game.run(0.1);
  EXPECT_NE(game.demo(), nullptr);
  game.command("stopdemo");
  game.run(0.5);
  EXPECT_EQ(game.demo(), nullptr) << "the player has stopped it";
}

TEST(HostDemos, AttractModeGivesUpOnBrokenDemos) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/demo1.dem", std::string_view("not a demo"));
  game.restart();
  game.run(1);
  EXPECT_EQ(game.demo(), nullptr);
  EXPECT_EQ(std::ranges::count_if(
                game.lines(), [](const std::string& line) { return line.find("demo1.dem") != line.npos; }),
            1);
}

TEST(HostDemos, AttractModeDefaultsToDemo1To3) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.run(0.1);
  EXPECT_EQ(game.demo(), nullptr);
  game.folder().write("id1/demo2.dem", make_recording({}).bytes);
  game.restart();
  game.run(0.1);
  EXPECT_NE(game.demo(), nullptr);
  game.command("stopdemo");
  game.run(0.1);
  EXPECT_EQ(game.demo(), nullptr);
  game.folder().write("id1/autoexec.cfg", std::string_view("cl_startdemos 0\n"));
  game.restart();
  game.run(0.1);
  EXPECT_EQ(game.demo(), nullptr);
}

// The game must have been started with `maxplayers 2` or more.
bool start_listen_game(HeadlessHost& io_game) {
  io_game.host().services.open_socket = [](std::uint16_t) {
    return platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  };
  io_game.command("map small");
  return io_game.run_until_playing();
}

// A game that others may join records from the start of a level on, also of one that the player starts.
TEST(HostDemos, ARecordingWaitsForTheNextLevelAndGame) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"maxplayers 2"});
  ASSERT_TRUE(start_listen_game(game));
  EXPECT_EQ(game.session().server()->game->setup().dialect.protocol, net::Protocol::kFitzQuake);
  game.command("record film; map small");
  game.run(0.2);
  ASSERT_TRUE(game.run_until_playing());
  game.command("maxplayers 3; map small");  // another server
  game.run(0.2);
  ASSERT_TRUE(game.run_until_playing());
  game.run(1);
  game.command("stop");
  game.run(0.1);
  EXPECT_TRUE(std::filesystem::exists(game.folder().path() / "id1/film.dem"));
  game.command("record other; maxplayers 4; map small");
  game.run(0.2);
  ASSERT_TRUE(game.run_until_playing());
  game.command("stop");
  game.run(0.1);
  EXPECT_TRUE(std::filesystem::exists(game.folder().path() / "id1/other.dem"));
}

TEST(HostDemos, ARecordingThatWaitsEndsWithALineIfTheServerDropsThePlayer) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"maxplayers 2"});
  ASSERT_TRUE(start_listen_game(game));
  game.command("record film");
  game.run(0.1);
  server::drop_client(*game.session().server(), 0, "Too good.");
  game.run(0.2);
  EXPECT_TRUE(game.has_printed("Too good."));
  EXPECT_TRUE(game.has_printed("film.dem: nothing was recorded"));
}

}  // namespace
}  // namespace temblor::test
