// Places of a level, and what players report of themselves in team chat.
#include "host/commands/chat_macros.h"

#include <gtest/gtest.h>

#include "client/hud/items.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "platform/posix/udp_socket.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

client::Game make_player() {
  client::Game game;
  game.stats[static_cast<std::size_t>(client::Stat::kHealth)] = 85;
  game.stats[static_cast<std::size_t>(client::Stat::kArmor)] = 150;
  game.stats[static_cast<std::size_t>(client::Stat::kRockets)] = 7;
  game.stats[static_cast<std::size_t>(client::Stat::kCells)] = 30;
  game.data.items = 1u << 0 | 1u << 5 | 1u << 6 | client::kItemQuad;
  return game;
}

std::string expand(std::string_view text) {
  return host::expand_chat_macros(text, make_player(), {"red armor", "lava"}, 125.5);
}

TEST(ChatMacros, StandForThePlayersState) {
  EXPECT_EQ(expand("%h/%a at %l"), "85/150 at red armor");
  EXPECT_EQ(expand("died at %d"), "died at lava");
  EXPECT_EQ(expand("%w, %r rockets, %c cells, %p, %t"), "rl lg, 7 rockets, 30 cells, quad, 2:05");
  client::Game poor;
  EXPECT_EQ(host::expand_chat_macros("%w %p", poor, {}, 0), "no weapons no powerups");
}

TEST(ChatMacros, LeaveOtherTextAsItIs) {
  for (const char* text : {"", "hello", "100% sure", "%", "50%", "%H %x", "% h"})
    EXPECT_EQ(expand(text), text);
  EXPECT_EQ(expand("%%h"), "%h");
  EXPECT_EQ(expand("%%%h"), "%85");
}

// Two programs, connected by UDP.
class TeamChat : public ::testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_QUAKEC();
    served_.emplace();
    joined_.emplace();
  }
  // Connects both. Files that a test writes must be there before.
  void connect() {
    served_->restart();
    joined_->restart();
    served_->host().services.open_socket = [this](std::uint16_t) {
      auto socket = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
      if (socket.ok()) address_ = (*socket)->local_address();
      return socket;
    };
    joined_->host().services.open_socket = [](std::uint16_t) {
      return platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
    };
    joined_->host().services.look_up = platform::posix::look_up;
    served_->command("name Anna; maxplayers 2; deathmatch 1; map small");
    ASSERT_TRUE(served_->run_until_playing());
    joined_->command(fmt::format("name Bert; connect 127.0.0.1:{}", address_.port));
    for (int i = 0; i < 500 && !joined_->session().is_playing(); ++i) run(1.0 / 72);
    ASSERT_TRUE(joined_->session().is_playing());
    run(1);
  }
  void run(double seconds) {
    for (double done = 0; done < seconds; done += 1.0 / 72) {
      served_->run(1.0 / 72);
      joined_->run(1.0 / 72);
    }
  }

  std::optional<HeadlessHost> served_, joined_;
  platform::Address address_;
};

TEST_F(TeamChat, TellsTheOtherPlayerWhereOneIs) {
  served_->folder().write("id1/locs/small.loc", "0 0 0 wrong file, which Bert lacks\n");
  joined_->folder().write("id1/maps/small.loc", "-9999,-9999,-9999,9999,9999,9999,\"old court\"\n");
  connect();
  joined_->command("say_team \"%h health at %l\"");
  run(1);
  EXPECT_TRUE(served_->has_printed("(Bert): 100 health at old court"));
  EXPECT_TRUE(joined_->has_printed("(Bert): 100 health at old court"));
  joined_->command("say %h is not expanded for all");
  served_->command("say_team at %l");
  run(1);
  EXPECT_TRUE(served_->has_printed("Bert: %h is not expanded for all"));
  EXPECT_TRUE(joined_->has_printed("(Anna): at wrong file, which Bert lacks"));
}

TEST_F(TeamChat, WithoutAFileOneIsSomewhere) {
  connect();
  joined_->command("say_team at %l");
  joined_->command("loc");
  run(1);
  EXPECT_TRUE(served_->has_printed("(Bert): at somewhere"));
  EXPECT_TRUE(joined_->has_printed("there is no .loc file"));
}

TEST(LocationCommand, NamesThePlace) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  game.folder().write("id1/locs/small.loc", "0 0 0 court\n");
  game.restart(nullptr, {"loc", "map small"});
  ASSERT_TRUE(game.run_until_playing());
  EXPECT_TRUE(game.has_printed("loc: start or join a game first"));
  game.command("loc");
  game.run(0.3);
  EXPECT_TRUE(game.has_printed("You are at: court"));
}

}  // namespace
}  // namespace temblor::test
