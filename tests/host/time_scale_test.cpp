// host_timescale: the speed of the game's time.
#include <gtest/gtest.h>

#include <algorithm>

#include "client/demo/demo_session.h"
#include "client/session/connection.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "platform/posix/udp_socket.h"
#include "server/server.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

class TimeScale : public ::testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_QUAKEC();
    game_.emplace(std::vector<std::string>{"map small"});
    ASSERT_TRUE(game_->run_until_playing());
  }
  double game_time_s() { return game_->session().server()->game->time_s(); }
  // The game time that passes in four seconds.
  double play(double scale) {
    game_->command("host_timescale " + std::to_string(scale));
    game_->run(0.1);
    const double before_s = game_time_s();
    game_->run(4);
    return game_time_s() - before_s;
  }
  std::ptrdiff_t count_lines(std::string_view part) {
    return std::ranges::count_if(
        game_->lines(), [&](const std::string& line) { return line.find(part) != std::string::npos; });
  }

  std::optional<HeadlessHost> game_;
};

TEST_F(TimeScale, SlowsAndHurriesALocalGame) {
  EXPECT_NEAR(play(1), 4, 0.05);
  EXPECT_NEAR(play(0.5), 2, 0.05);
  EXPECT_NEAR(play(0), 4, 0.05) << "off";
  EXPECT_NEAR(play(3), 12, 0.1);
  EXPECT_EQ(count_lines("host_timescale is ignored"), 0);
}

// The player moves as far in the same game time.
TEST_F(TimeScale, MovesStayInStepWithTheGame) {
  const auto fly = [&](double scale) {
    game_->command("setpos 48 256 100 0 0 0");
    game_->command("host_timescale " + std::to_string(scale));
    game_->run(0.3);
    const float before = game_->session().server()->game->player(0)[server::field::kOrigin].x;
    game_->command("+forward");
    game_->run(0.5 / scale);
    game_->command("-forward");
    game_->run(0.05);
    return game_->session().server()->game->player(0)[server::field::kOrigin].x - before;
  };
  const float normal = fly(1);
  EXPECT_GT(normal, 20);
  EXPECT_NEAR(fly(0.5), normal, 0.15f * normal);
  EXPECT_NEAR(fly(2), normal, 0.15f * normal);
}

TEST_F(TimeScale, ScalesDemos) {
  game_->command("record long");
  game_->run(6);
  game_->command("stop; playdemo long");
  game_->run(0.2);
  ASSERT_NE(game_->demo(), nullptr);
  const auto pass = [&](double seconds) {
    const double before_s = game_->demo()->time_s();
    game_->run(seconds);
    return game_->demo()->time_s() - before_s;
  };
  EXPECT_NEAR(pass(1), 1, 0.05);
  game_->command("host_timescale 0.25");
  game_->run(0.02);
  EXPECT_NEAR(pass(2), 0.5, 0.05);
}

// A second player joins over UDP: both clocks must agree from then on.
TEST_F(TimeScale, IsIgnoredWhileOthersPlay) {
  std::uint16_t port = 0;
  game_->host().services.open_socket = [&](std::uint16_t) {
    auto socket = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
    if (socket.ok()) port = (*socket)->local_address().port;
    return socket;
  };
  game_->command("maxplayers 2; map small");
  game_->run(0.2);
  ASSERT_TRUE(game_->run_until_playing());
  EXPECT_NEAR(play(0.5), 2, 0.05) << "nobody else is here";
  auto socket = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  ASSERT_TRUE(socket.ok());
  client::Connection other(std::move(*socket), {.name = "other"});
  other.connect(platform::ip4_address({127, 0, 0, 1}, port), 0);
  for (int i = 0; i < 500 && !other.is_playing(); ++i) {
    game_->run(0.01, 0.01);
    other.update(0.01 * i);
  }
  ASSERT_TRUE(other.is_playing());
  EXPECT_NEAR(play(0.5), 4, 0.05);
  EXPECT_EQ(count_lines("host_timescale is ignored: other players share this game"), 1);
}

}  // namespace
}  // namespace temblor::test
