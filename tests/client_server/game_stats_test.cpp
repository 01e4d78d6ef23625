// Values from the server's QuakeC for the HUDs of clients: stats that game code chooses with clientstat() and
// globalstat(), and the ends of power-ups.
#include <gtest/gtest.h>

#include "client_server/served_game.h"
#include "server/game/entity_fields.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

constexpr std::string_view kStatBuiltins = R"(
void(float number, float type, ...) clientstat = #232;
void(float number, float type, string name) globalstat = #233;
.float courage;
.string quest;
.vector goal;
.entity rival;
float weather;
string news;
)";

// The game with these lines in worldspawn.
std::string program_with_stats(std::string_view lines) {
  std::string program = small_program(kStatBuiltins);
  constexpr std::string_view kPlace = "  lightstyle(1, \"az\");\n";
  return program.insert(program.find(kPlace), lines);
}

constexpr std::string_view kStats = R"(
  clientstat(32, 2, courage);
  clientstat(33, 1, quest);
  clientstat(40, 3, goal);
  clientstat(50, 4, rival);
  globalstat(254, 2, "weather");
  globalstat(255, 1, "news");
  weather = 0.25;
  news = "two\nlines; quit";
)";

float number(const client::Game& game, std::uint8_t stat) {
  return std::get<float>(game.game_stats.at(stat));
}
std::string text(const client::Game& game, std::uint8_t stat) {
  return std::get<std::string>(game.game_stats.at(stat));
}

void set_word(ServedGame& io_game, std::string_view field, std::uint32_t word) {
  const auto* definition = io_game.game().machine().program().find_field(field);
  io_game.game().machine().entity(server::Game::player_index(0))[definition->offset] = word;
}

TEST(GameStats, ArriveWithTheirTypes) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_stats(kStats), {.max_clients = 2});
  served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(0));
  served.run(0.5);
  set_word(served, "courage", std::bit_cast<std::uint32_t>(7.5f));
  set_word(served, "goal_y", std::bit_cast<std::uint32_t>(-2.0f));
  set_word(served, "rival", 2);
  served.run(0.5);
  const client::Game& game = served.client(0).state().game();
  EXPECT_EQ(number(game, 32), 7.5f);
  EXPECT_EQ(text(game, 33), "");
  EXPECT_EQ(number(game, 40), 0);
  EXPECT_EQ(number(game, 41), -2);
  EXPECT_EQ(number(game, 42), 0);
  EXPECT_EQ(game.stats[50], 2);
  EXPECT_EQ(number(game, 254), 0.25f);
  EXPECT_EQ(text(game, 255), "two\nlines; quit");
  EXPECT_TRUE(served.client(0).take_commands().empty()) << "no stat is a command";
}

// Each player gets its own values; one who joins later gets those that others have already.
TEST(GameStats, BelongToEachPlayer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_stats(kStats), {.max_clients = 2});
  served.add_client("first");
  ASSERT_TRUE(served.run_until_playing(0));
  set_word(served, "courage", std::bit_cast<std::uint32_t>(3.0f));
  served.run(0.5);
  served.add_client("second");
  ASSERT_TRUE(served.run_until_playing(1));
  served.run(0.5);
  EXPECT_EQ(number(served.client(0).state().game(), 32), 3);
  EXPECT_EQ(number(served.client(1).state().game(), 32), 0);
  EXPECT_EQ(number(served.client(1).state().game(), 254), 0.25f);
}

// A value that changes in every tick must not fill the queue of reliable messages.
TEST(GameStats, ThatChangeAlwaysArriveOverABadNetwork) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(program_with_stats("globalstat(99, 2, \"time\");\n"),
                    {.conditions = {.loss = 0.2, .delay_s = 0.1}});
  served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(0));
  served.run(20);
  EXPECT_NEAR(number(served.client(0).state().game(), 99), served.game().time_s(), 3);
  EXPECT_LT(served.server().clients[0].queued_bytes, 4096u);
}

TEST(PowerupEnds, ReachTheirPlayer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(".float super_damage_finished, radsuit_finished;"), {.max_clients = 2});
  for (const char* const name : {"one", "two"}) served.add_client(name);
  ASSERT_TRUE(served.run_until_playing(0));
  ASSERT_TRUE(served.run_until_playing(1));
  served.run(0.5);
  const auto set = [&](std::string_view field, float value) {
    set_word(served, field, std::bit_cast<std::uint32_t>(value));
  };
  constexpr float kSuit = 1u << 21, kQuad = 1u << 22;
  set("super_damage_finished", 47.25f);
  set("radsuit_finished", 12.5f);
  set("items", kQuad);
  served.run(0.5);
  const client::Game& game = served.client(0).state().game();
  EXPECT_EQ(game.powerup_ends_s[22], 47.25f);
  EXPECT_EQ(game.powerup_ends_s[21], 0) << "the player does not have it";
  set("items", kQuad + kSuit);
  set("super_damage_finished", 60);
  served.run(0.5);
  EXPECT_EQ(game.powerup_ends_s[22], 60);
  EXPECT_EQ(game.powerup_ends_s[21], 12.5f);
  EXPECT_EQ(served.client(1).state().game().powerup_ends_s[22], 0);
}

// A monster that has chosen the second player, near and far, dead and alive.
TEST(CombatStates, ReachTheHuntedPlayer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 2});
  for (const char* const name : {"one", "two"}) served.add_client(name);
  ASSERT_TRUE(served.run_until_playing(0));
  ASSERT_TRUE(served.run_until_playing(1));
  served.run(0.5);
  server::Edicts& edicts = served.game().world().edicts;
  const server::Edict monster = edicts[edicts.spawn(served.game().time_s()).value()];
  monster.set(server::field::kFlags, static_cast<float>(server::flag::kMonster));
  monster.set(server::field::kHealth, 10.0f);
  monster.set(server::field::kEnemy, server::Game::player_index(1));
  const auto is_hunted = [&](std::size_t client) { return served.client(client).state().game().is_hunted; };
  const auto move_monster = [&](float distance) {
    const server::Edict player = served.game().player(1);
    monster.set(server::field::kOrigin, player[server::field::kOrigin] + math::Vec3{distance, 0, 0});
  };
  move_monster(2000);
  served.run(0.5);
  EXPECT_FALSE(is_hunted(1)) << "too far away";
  move_monster(1000);
  served.run(0.5);
  EXPECT_TRUE(is_hunted(1));
  EXPECT_FALSE(is_hunted(0));
  monster.set(server::field::kHealth, 0.0f);
  served.run(1);
  EXPECT_TRUE(is_hunted(1)) << "for two seconds";
  served.run(2);
  EXPECT_FALSE(is_hunted(1));
}

TEST(GameStats, WithBadNumbersOrNamesOnlyWarn) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(
      program_with_stats("clientstat(31, 2, courage); globalstat(256, 2, \"weather\");\n"
                         "globalstat(60, 2, \"nothing\"); clientstat(255, 3, goal);\n"));
  EXPECT_NE(served.console().find("stat 31 is not 32 to 255"), std::string::npos) << served.console();
  EXPECT_NE(served.console().find("stat 256 is not 32 to 255"), std::string::npos);
  EXPECT_NE(served.console().find("no global \"nothing\""), std::string::npos);
  EXPECT_EQ(served.game().context().sent_stats.size(), 1u);
}

}  // namespace
}  // namespace temblor::test
