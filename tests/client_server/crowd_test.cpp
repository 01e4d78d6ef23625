// More visible entities than one packet has room for.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

// After a second, the game spawns `temp1` boxes around the player, none of which moves, and the player owns
// the last one.
std::string crowded_program() {
  constexpr std::string_view kStill = "void() StartFrame = {};";
  std::string program = small_program();
  const std::size_t at = program.find(kStill);
  CHECK(at != std::string::npos);
  return program.replace(at, kStill.size(), R"(
float has_crowd;
void() StartFrame = {
  local float i; local vector at; local entity player, box;
  player = find(world, classname, "player");
  if (has_crowd || !player) return;
  has_crowd = 1;
  i = 0;
  while (i < cvar("temp1")) {
    box = spawn();
    setmodel(box, "progs/player.mdl");
    at = '0 0 0';
    at_x = random() * 128 - 64; at_y = random() * 128 - 64; at_z = random() * 64;
    setorigin(box, player.origin + at);
    i = i + 1;
  }
  box.owner = player;
};
)");
}

std::set<std::uint16_t> seen_entities(ServedGame& served, std::size_t me) {
  std::vector<client::EntityPlace> places;
  served.client(me).state().copy_latest_places(places);
  std::set<std::uint16_t> numbers;
  for (const client::EntityPlace& place : places) numbers.insert(place.number);
  return numbers;
}

TEST(Crowd, ArrivesCompletelyOnTheSameMachine) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(crowded_program(), {.is_real = true});
  ASSERT_TRUE(served.variables().set("temp1", "2000").ok());
  ASSERT_TRUE(served.variables().set("sv_protocol", "999").ok());
  ASSERT_TRUE(server::start_map(served.server(), "small").ok());
  const std::size_t me = served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(me)) << served.console();
  served.run(0.5);
  EXPECT_GE(seen_entities(served, me).size(), 2001u);
  EXPECT_EQ(served.server().clients[0].sent_counts.entities_left_out, 0u);
}

class CrowdInANetwork : public ::testing::TestWithParam<const char*> {};

TEST_P(CrowdInANetwork, ArrivesInTurnAndWhatIsOwnAlways) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(crowded_program());
  ASSERT_TRUE(served.variables().set("temp1", "400").ok());
  ASSERT_TRUE(served.variables().set("sv_protocol", GetParam()).ok());
  ASSERT_TRUE(server::start_map(served.server(), "small").ok());
  const std::size_t me = served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(me)) << served.console();
  served.run(1);
  EXPECT_GT(served.server().clients[0].sent_counts.entities_left_out, 0u);
  const auto own_missile = static_cast<std::uint16_t>(served.game().world().edicts.count() - 1);
  std::set<std::uint16_t> seen, always = seen_entities(served, me);
  constexpr int kTicks = 36;  // half a second
  for (int tick = 0; tick < kTicks; ++tick) {
    served.run(kTick_s);
    const std::set<std::uint16_t> now = seen_entities(served, me);
    seen.insert(now.begin(), now.end());
    std::erase_if(always, [&](std::uint16_t number) { return !now.contains(number); });
  }
  EXPECT_GE(seen.size(), 401u) << "everything within half a second";
  EXPECT_TRUE(always.contains(1)) << "the player";
  EXPECT_TRUE(always.contains(own_missile));
  EXPECT_GT(always.size(), 20u) << "the nearest ones do not flicker";
  served.command("net_stats");
  served.run(kTick_s);
  EXPECT_THAT(served.console(), ::testing::ContainsRegex("was sent [0-9]+ of 402 visible entities"));
}

INSTANTIATE_TEST_SUITE_P(Protocols, CrowdInANetwork, ::testing::Values("15", "666", "999"));

}  // namespace
}  // namespace temblor::test
