// Recordings watched in the game as a whole.
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/game/dem.h"
#include "host/played_host.h"
#include "support/generated_demo.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using platform::Key;

// A program in which the made recording can be played.
class Watching : public PlayedHost {
 public:
  explicit Watching(const std::vector<std::string>& commands) {
    folder().write("id1/made.dem", make_recording({}).bytes);
    for (const std::string& line : commands) command(line);
    run(0.1);
  }
};

double second(PlayedHost& io_played) {
  return io_played.host().demo()->time_s() - io_played.host().demo()->begin_s();
}

void tap(PlayedHost& io_played, Key key) {
  io_played.press(key);
  io_played.release(key);
  io_played.run(0.02);
}

TEST(HostDemos, AreWatchedWithKeys) {
  SKIP_WITHOUT_QUAKEC();
  Watching played({"playdemo made"});
  ASSERT_NE(played.host().demo(), nullptr);
  played.run(2);
  EXPECT_NEAR(second(played), 2.1, 0.1);
  tap(played, Key::kSpace);
  const double paused_at = second(played);
  played.run(1);
  EXPECT_EQ(second(played), paused_at);
  tap(played, Key::kRightArrow);
  EXPECT_NEAR(second(played), paused_at + 5, 1e-6);
  tap(played, Key{'.'});
  EXPECT_GT(second(played), paused_at + 5);
  tap(played, Key::kHome);
  EXPECT_EQ(second(played), 0);
  tap(played, Key::kSpace);
  tap(played, Key::kUpArrow);
  EXPECT_EQ(played.host().demo()->speed(), 2);
  played.run(9);
  EXPECT_EQ(played.host().demo(), nullptr) << "it is over";
}

TEST(HostDemos, AreSoughtInByCommand) {
  SKIP_WITHOUT_QUAKEC();
  Watching played({"playdemo made", "demo_pause", "demo_seek 7", "demo_speed 0.5"});
  EXPECT_NEAR(second(played), 7, 1e-6);
  played.command("demo_seek +2");
  played.run(0.1);
  EXPECT_NEAR(second(played), 9, 1e-6);
  played.command("stopdemo; demo_seek 1");
  played.run(0.1);
  EXPECT_EQ(played.host().demo(), nullptr);
}

// What it prints is printed once, however it is played.
TEST(HostDemos, PrintWhatTheyRecorded) {
  SKIP_WITHOUT_QUAKEC();
  formats::DemWriter writer;
  PlayedHost played;
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
  played.folder().write("id1/talk.dem", std::move(writer).take());
  played.command("playdemo talk");
  played.run(4);
  EXPECT_EQ(std::count(played.lines().begin(), played.lines().end(), "good morning"), 1);
}

TEST(HostDemos, AreMeasured) {
  SKIP_WITHOUT_QUAKEC();
  Watching played({"timedemo made"});
  played.run(10);
  EXPECT_EQ(played.host().demo(), nullptr);
  EXPECT_TRUE(played.has_printed(" fps"));
}

TEST(HostDemos, ThatAreNotThereOrDamagedAreSaid) {
  SKIP_WITHOUT_QUAKEC();
  Watching played({"playdemo nothing"});
  EXPECT_TRUE(played.has_printed("nothing.dem"));
  base::ByteVector bytes = make_recording({}).bytes;
  std::fill(bytes.begin() + 3000, bytes.end(), std::byte{0xee});
  played.folder().write("id1/damaged.dem", bytes);
  played.command("playdemo damaged");
  played.run(0.1);
  EXPECT_NE(played.host().demo(), nullptr) << "what is whole is shown";
  EXPECT_FALSE(played.has_printed("damaged.dem: "));
  played.run(20);
  EXPECT_TRUE(played.has_printed("damaged.dem: "));
  EXPECT_EQ(played.host().demo(), nullptr);
}

TEST(HostDemos, AreShownToNobodyOneAfterAnother) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played;
  played.folder().write("id1/first.dem", make_recording({}).bytes);
  played.folder().write("id1/broken.dem", std::string_view("no recording"));
  played.folder().write("id1/second.dem", make_recording({}).bytes);
  played.folder().write("id1/quake.rc",
                        std::string_view("exec default.cfg\nstartdemos first broken second\n"));
  played.start_again();
  played.run(1);
  ASSERT_NE(played.host().demo(), nullptr) << "behind the menu";
  const double length_s = played.host().demo()->end_s() - played.host().demo()->begin_s();
  played.run(length_s);
  ASSERT_NE(played.host().demo(), nullptr);
  EXPECT_LT(second(played), 2) << "the second one";
  EXPECT_TRUE(played.has_printed("broken.dem"));
  played.run(length_s);
  ASSERT_NE(played.host().demo(), nullptr) << "the first again";
  tap(played, Key::kEscape);
  const double before_s = second(played);
  tap(played, Key::kRightArrow);
  EXPECT_LT(second(played), before_s + 1) << "it is no control of recordings but opens the menu";
  played.command("map small");
  ASSERT_TRUE(played.run_until_playing());
  EXPECT_EQ(played.host().demo(), nullptr);
  played.run(1);
  EXPECT_EQ(played.host().demo(), nullptr);
}

TEST(HostDemos, WithoutAListTheFirstThreeByNameAreShown) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played;
  played.run(0.1);
  EXPECT_EQ(played.host().demo(), nullptr);
  played.folder().write("id1/demo2.dem", make_recording({}).bytes);
  played.start_again();
  played.run(0.1);
  EXPECT_NE(played.host().demo(), nullptr);
  played.command("stopdemo");
  played.run(0.1);
  EXPECT_EQ(played.host().demo(), nullptr);
}

}  // namespace
}  // namespace temblor::test
