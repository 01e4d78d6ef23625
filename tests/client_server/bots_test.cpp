// Bots on a server, as people see them: on the score board, in their slots, and gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Makes `number` bots as soon as the level runs; they walk ahead and look around.
std::string program_with_bots(int number) {
  std::string program = small_program(fmt::format(R"(
    entity() spawnclient = #454;
    void(entity e) dropclient = #453;
    float(entity e) clienttype = #455;
    .vector movement;
    .float clientcolors;
    float made;
    void() make_bots = {{
      local entity bot;
      if (time < 2) return;
      while (made < {}) {{
        made = made + 1;
        bot = spawnclient();
        if (bot) {{
          bot.netname = "Robin";
          bot.clientcolors = 67;
          bot.frags = 3;
          setorigin(bot, bot.origin + '48 0 0' * made);
        }}
      }}
    }};
    void() bot_walks = {{
      if (clienttype(self) != 2) return;
      self.movement = '200 0 0';
      self.v_angle_y = self.v_angle_y + 1;
    }};
  )",
                                                  number));
  const auto replace = [&](std::string_view what, std::string_view with) {
    CHECK(program.find(what) != std::string::npos);
    program.replace(program.find(what), what.size(), with);
  };
  replace("void() StartFrame = {};", "void() StartFrame = { make_bots(); };");
  replace("void() PlayerPreThink = {};", "void() PlayerPreThink = { bot_walks(); };");
  return program;
}

TEST(Bots, AreOnTheScoreBoardAndMove) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_bots(1), {.max_clients = 4});
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(2);
  const auto& players = served.client(me).state().game().players;
  ASSERT_EQ(players.size(), 4u);
  EXPECT_EQ(players[0].name, "tester");
  EXPECT_EQ(players[3].name, "Robin");
  EXPECT_EQ(players[3].frags, 3);
  EXPECT_EQ(players[3].shirt, 4);
  EXPECT_EQ(players[3].pants, 3);
  const math::Vec3 before = served.game().player(3)[server::field::kOrigin];
  served.run(1);
  EXPECT_GT(glm::length(served.game().player(3)[server::field::kOrigin] - before), 20);
  served.command("status");
  served.run(0.1);
  EXPECT_THAT(served.console(), HasSubstr("Robin"));
}

TEST(Bots, MakeRoomForPeople) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_bots(4), {.max_clients = 4});
  served.run(3);
  for (std::size_t slot = 0; slot < 4; ++slot) EXPECT_TRUE(served.game().is_bot(slot));
  for (int i = 0; i < 4; ++i) {
    const std::size_t one = served.add_client("tester");
    EXPECT_TRUE(served.run_until_playing(one)) << i << served.client(one).disconnect_reason();
  }
  for (std::size_t slot = 0; slot < 4; ++slot) EXPECT_FALSE(served.game().is_bot(slot));
}

TEST(Bots, CanBeKickedAndReturnWithTheNextLevel) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_bots(1), {.max_clients = 4});
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(2);
  served.command("ban Robin");
  served.run(0.5);
  EXPECT_THAT(served.console(), HasSubstr("no address"));
  served.command("kick Robin");
  served.run(0.5);
  EXPECT_FALSE(served.game().is_bot(3));
  EXPECT_EQ(served.client(me).state().game().players[3].name, "");
  served.command("changelevel small");
  served.run(5);
  EXPECT_TRUE(served.client(me).is_playing());
  EXPECT_TRUE(served.game().is_bot(3));
  EXPECT_EQ(served.client(me).state().game().players[3].name, "Robin");
  served.command("record x 4");
  served.run(0.5);
  EXPECT_THAT(served.console(), HasSubstr("no player 4 to record"));
  EXPECT_THAT(served.console(), Not(HasSubstr("failed")));
}

// Game code is reloaded while they play.
TEST(Bots, PlayOnWhenTheProgramIsReloaded) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_bots(2), {.max_clients = 4});
  const std::size_t me = served.add_client("tester");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(2);
  served.command("reload");
  served.run(5);
  EXPECT_THAT(served.console(), HasSubstr("the game continues"));
  EXPECT_TRUE(served.client(me).is_playing());
  EXPECT_TRUE(served.game().is_bot(3));
  EXPECT_EQ(served.client(me).state().game().players[2].name, "Robin");
}

}  // namespace
}  // namespace temblor::test
