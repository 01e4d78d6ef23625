// Snapshots when datagrams are lost, or sv_maxrate limits them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

constexpr double kDelay_s = 0.1;

// The game: a player makes a sound once per second, in a cloud of entities that move in every tick, so that
// there is much to send.
std::string beeping_program() {
  constexpr std::string_view kStill = "void() StartFrame = {};";
  std::string program = small_program();
  const std::size_t at = program.find(kStill);
  CHECK(at != std::string::npos);
  return program.replace(at, kStill.size(), R"(
float next_beep, has_cloud;
void() swirl = {
  local vector at;
  at_x = random() * 128 - 64; at_y = random() * 128 - 64; at_z = random() * 64;
  setorigin(self, self.oldorigin + at);
  self.nextthink = time + 0.01;
};
void() cloud = {
  local float i; local entity spot, mote;
  has_cloud = 1;
  spot = find(world, classname, "info_player_start");
  i = 0;
  while (i < 15) {
    mote = spawn();
    setmodel(mote, "progs/player.mdl");
    mote.oldorigin = spot.origin;
    mote.think = swirl; mote.nextthink = time + 0.01;
    i = i + 1;
  }
};
void() StartFrame = {
  if (!has_cloud && time > 1.5) cloud();
  local entity player;
  if (time < next_beep) return;
  next_beep = time + 1;
  player = find(world, classname, "player");
  if (player) sound(player, 1, "misc/hello.wav", 1, 0);
};
)");
}

struct Freezes {
  double longest_s = 0;
  int lost_windows = 0;
};

// A minute in which the network loses everything for one tick, about every 1.2 s.
Freezes play_with_losses(ServedGame& served, std::size_t me) {
  Freezes freezes;
  std::uint64_t updates = served.client(me).updates();
  double updated_at_s = served.now_s();
  for (int tick = 1; tick <= 60 * 72; ++tick) {
    const bool loses = tick % 89 == 0;
    freezes.lost_windows += loses;
    served.network().set_conditions({.loss = loses ? 1.0 : 0.0, .delay_s = kDelay_s});
    served.run(kTick_s);
    if (served.client(me).updates() == updates) continue;
    updates = served.client(me).updates();
    freezes.longest_s = std::max(freezes.longest_s, served.now_s() - updated_at_s);
    updated_at_s = served.now_s();
  }
  return freezes;
}

// Michael Abrash, "Quake: a post-mortem and a glimpse into the future": all that a dropped packet means is a
// freezing of the world for one server timeslice, where reliable delivery gave a glitch of several hundred
// milliseconds at 200 ms ping.
TEST(Updates, ALostDatagramFreezesOneTickAndAReliableOneARoundTripAndMore) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.conditions = {.delay_s = kDelay_s}});
  const std::size_t me = served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(5);  // the channel knows its round trip
  const Freezes freezes = play_with_losses(served, me);
  EXPECT_GT(freezes.lost_windows, 40);
  EXPECT_NEAR(freezes.longest_s, 2 * kTick_s, kTick_s / 10) << "one tick was missed";

  ASSERT_TRUE(served.variables().set("sv_reliableupdates", "1").ok());
  served.run(5);
  const Freezes reliable = play_with_losses(served, me);
  EXPECT_GT(reliable.longest_s, 2 * kDelay_s + 0.1) << "a round trip, and the wait for it";
  EXPECT_LT(reliable.longest_s, 2);
  EXPECT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
  ::testing::Test::RecordProperty("frozen_unreliable_ms", static_cast<int>(freezes.longest_s * 1000));
  ::testing::Test::RecordProperty("frozen_reliable_ms", static_cast<int>(reliable.longest_s * 1000));

  ASSERT_TRUE(served.variables().set("sv_reliableupdates", "0").ok());
  served.run(1);
  EXPECT_NEAR(play_with_losses(served, me).longest_s, 2 * kTick_s, kTick_s / 10) << "and back again";
}

TEST(Updates, ATurnByTheGameSurvivesTheLossOfItsDatagram) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(1);
  const server::Edict player = served.game().player(0);
  player.set(server::field::kAngles, math::Vec3{0, 123, 0});
  player.set(server::field::kFixAngle, 1.0f);
  served.network().set_conditions({.loss = 1});
  served.run(kTick_s);
  EXPECT_EQ(player[server::field::kFixAngle], 0.0f);
  served.network().set_conditions({});
  served.run(2 * kTick_s);
  EXPECT_NEAR(served.client(me).state().game().set_angles_deg.y, 123, 360.0 / 256);
}

TEST(Updates, ARateLimitsWhatAClientIsSentButNoSoundIsLost) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(beeping_program());
  const std::size_t me = served.add_client("player");
  ASSERT_TRUE(served.run_until_playing(me));
  const platform::Address my_address = platform::ip4_address({10, 0, 0, 2}, 4000);
  // Packet headers do not count.
  const auto content = [&] {
    return served.network().bytes_sent_to(my_address) - 8 * served.network().datagrams_sent_to(my_address);
  };
  const auto bytes_in = [&](double seconds) {
    const std::uint64_t before = content();
    served.run(seconds);
    return static_cast<double>(content() - before) / seconds;
  };
  const double free_rate = bytes_in(10);
  constexpr double kRate = 2500;  // the minimum of sv_maxrate
  ASSERT_GT(free_rate, 1.3 * kRate) << "else there is nothing to limit";
  ASSERT_TRUE(served.variables().set("sv_maxrate", fmt::format("{}", kRate)).ok());
  const std::uint64_t updates_before = served.client(me).updates();
  const std::size_t sounds_before = served.sounds(me);
  const double bounded_rate = bytes_in(10);
  EXPECT_LT(bounded_rate, kRate * 1.3);
  EXPECT_GT(bounded_rate, kRate * 0.8);
  EXPECT_GT(served.client(me).updates(), updates_before + 200) << "evenly, twenty per second";
  EXPECT_NEAR(static_cast<double>(served.sounds(me) - sounds_before), 10, 1);
}

}  // namespace
}  // namespace temblor::test
