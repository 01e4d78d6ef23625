// Lockstep games over a network that loses packets: all peers play the same game, and notice if they do not.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "lockstep/lockstep_party.h"
#include "lockstep/play_replay.h"
#include "platform/posix/udp_socket.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

net::Move random_play(Random& io_random) {
  net::Move move;
  const auto pitch_deg = static_cast<float>(io_random.uniform(-80, 80));
  const auto yaw_deg = static_cast<float>(io_random.uniform(-180, 180));
  move.angles_deg = {pitch_deg, yaw_deg, 0};
  move.forward = static_cast<std::int16_t>(io_random.uniform(-400, 400));
  move.side = static_cast<std::int16_t>(io_random.uniform(-400, 400));
  move.buttons = static_cast<std::uint8_t>(io_random.below(4));
  move.impulse = static_cast<std::uint8_t>(io_random.below(9));
  return move;
}

// All players run around for that long.
void play(LockstepParty& io_party, std::size_t players, double seconds, std::uint64_t seed = 7) {
  Random random(seed);
  for (double played_s = 0; played_s < seconds; played_s += 0.25) {
    std::vector<net::Move> moves;
    for (std::size_t i = 0; i < players; ++i) moves.push_back(random_play(random));
    io_party.run(0.25, moves);
  }
}

// The game with the fewest ticks, and every other one when it had played as many, are equal: each tick was
// compared on the way.
void expect_same_games(LockstepParty& io_party, std::size_t players) {
  for (std::size_t i = 0; i < players; ++i) EXPECT_EQ(io_party.game(i).ended(), "") << i;
  const std::uint32_t ticks = io_party.game(0).ticks();
  for (std::size_t i = 1; i < players; ++i) {
    EXPECT_NEAR(io_party.game(i).ticks(), ticks, 60) << i;
    if (io_party.game(i).ticks() == ticks) {
      EXPECT_EQ(io_party.game(i).simulation().game().state_hash(),
                io_party.game(0).simulation().game().state_hash());
    }
  }
}

math::Vec3 origin(LockstepParty& io_party, std::size_t on, std::size_t player) {
  return io_party.game(on).simulation().game().player(player)[server::field::kOrigin];
}

TEST(Lockstep, TwoPeersPlayTheSameGame) {
  LockstepParty party;
  ASSERT_TRUE(party.run_until_playing());
  const math::Vec3 before = origin(party, 0, 1);
  play(party, 2, 10);
  expect_same_games(party, 2);
  EXPECT_GT(party.game(0).ticks(), 650u);
  EXPECT_NE(origin(party, 0, 1), before) << "the guest's moves reach the host's game";
  EXPECT_THAT(party.prints(0), HasSubstr("Lockstep: 2 of 2 players are here."));
}

TEST(Lockstep, FourPeersPlayTheSameGameWithBots) {
  LockstepParty party({.players = 4, .slots = 6, .variables = {{"deathmatch", "1"}, {"bot_fill", "6"}}});
  ASSERT_TRUE(party.run_until_playing());
  play(party, 4, 5);
  expect_same_games(party, 4);
  EXPECT_TRUE(party.game(3).simulation().game().is_bot(5));
}

TEST(Lockstep, LostPacketsDelayTheGameButDoNotChangeIt) {
  for (int seed = 0; seed < effort(4, 1); ++seed) {
    LockstepParty party({.conditions = {.loss = 0.1, .duplication = 0.05, .delay_s = 0.05, .jitter_s = 0.02},
                         .seed = static_cast<std::uint64_t>(seed + 1),
                         .delay_ticks = 8});
    ASSERT_TRUE(party.run_until_playing());
    play(party, 2, 10);
    expect_same_games(party, 2);
    EXPECT_GT(party.game(0).ticks(), 500u);
  }
}

// With an input delay above the round trip, the game does not wait for packets.
TEST(Lockstep, TheGameKeepsItsSpeedIfTheDelayCoversTheNetwork) {
  LockstepParty party({.conditions = {.delay_s = 0.04}, .delay_ticks = 8});
  ASSERT_TRUE(party.run_until_playing());
  const std::uint32_t before = party.game(1).ticks();
  party.run(10);
  EXPECT_NEAR(party.game(1).ticks() - before, 720, 4);
}

// Each client loads the next level on its own, and joins when it has.
TEST(Lockstep, AllPeersGoToTheNextLevel) {
  LockstepParty party({.variables = {{"deathmatch", "1"}, {"timelimit", "0.05"}, {"samelevel", "1"}}});
  ASSERT_TRUE(party.run_until_playing());
  play(party, 2, 15);
  expect_same_games(party, 2);
  EXPECT_LT(party.game(0).simulation().game().time_s(), party.game(0).ticks() / 72.0 - 5) << "a new level";
  EXPECT_TRUE(party.client(0).is_playing());
  EXPECT_TRUE(party.client(1).is_playing());
}

TEST(Lockstep, ADifferenceEndsTheGameAndNamesTickAndEntity) {
  LockstepParty party;
  ASSERT_TRUE(party.run_until_playing());
  play(party, 2, 1);
  // Something that is not a player, so that the next moves do not spread the difference at once.
  server::Game& game = party.game(1).simulation().game();
  const server::Edicts& edicts = game.world().edicts;
  std::uint32_t number = edicts.client_count() + 1;
  while (edicts.is_free(vm::EntityIndex{number})) ++number;
  server::Edict entity = game.world().edicts[vm::EntityIndex{number}];
  entity.set(server::field::kHealth, entity[server::field::kHealth] + 1);
  const std::uint32_t tick = party.game(1).ticks();
  play(party, 2, 4);
  const std::string expected = fmt::format("differs after tick {} ", tick + 1);
  EXPECT_THAT(party.game(0).ended(), HasSubstr("The game of player 2 " + expected));
  EXPECT_THAT(party.game(1).ended(), HasSubstr("The game of player 1 " + expected));
  EXPECT_THAT(party.game(0).ended(), HasSubstr(fmt::format("first in entity {} (", number)));
  EXPECT_THAT(party.game(1).ended(), HasSubstr(fmt::format("first in entity {} (", number)));
  EXPECT_FALSE(party.client(0).is_connected());
  EXPECT_EQ(party.client(0).disconnect_reason(), party.game(0).ended());
}

TEST(Lockstep, ADifferenceInRandomNumbersIsNoEntity) {
  LockstepParty party;
  ASSERT_TRUE(party.run_until_playing());
  vm::Machine& machine = party.game(1).simulation().game().machine();
  machine.set_global_float(server::global::kServerFlags, 12);
  party.run(4);
  EXPECT_THAT(party.game(0).ended(), HasSubstr("the same entities, but other globals"));
}

TEST(Lockstep, TheOthersGoOnWhenAGuestLeavesOrDies) {
  for (const bool is_killed : {false, true}) {
    LockstepParty party({.players = 3});
    ASSERT_TRUE(party.run_until_playing());
    if (is_killed) {
      party.network().set_conditions({.loss = 1});
      party.kill(2);
      party.network().set_conditions({});
    } else {
      party.client(2).disconnect();
    }
    party.run(12);
    const std::uint32_t before = party.game(0).ticks();
    party.run(1);
    EXPECT_NEAR(party.game(0).ticks(), before + 72, 2) << is_killed;
    EXPECT_EQ(party.game(1).ended(), "");
    EXPECT_EQ(party.game(0).simulation().server().clients[2].stage, server::ClientStage::kFree) << is_killed;
  }
}

TEST(Lockstep, TheGameEndsForAllWhenTheHostLeaves) {
  LockstepParty party;
  ASSERT_TRUE(party.run_until_playing());
  party.kill(0);
  party.run(0.5);
  EXPECT_EQ(party.game(1).ended(), "The host has left the game.");
}

TEST(Lockstep, AGuestWithoutAnswerGivesUp) {
  LockstepParty party({.conditions = {.loss = 1}});
  party.run(11);
  EXPECT_EQ(party.game(1).ended(), "10.0.0.1:26000 does not answer.");
}

TEST(Lockstep, LateGuestsAndOtherVersionsAreRefused) {
  LockstepParty party;
  const auto other_version = party.make_guest(8, "Temblor 0.0.1");
  const auto step = [&](lockstep::LockstepGame& io_guest) {
    for (int i = 0; i < 100 && io_guest.ended().empty(); ++i) {
      party.run(1.0 / 72);
      io_guest.step(party.now_s());
    }
    return io_guest.ended();
  };
  EXPECT_EQ(step(*other_version), "The game needs Temblor test.");
  ASSERT_TRUE(party.run_until_playing());
  EXPECT_EQ(step(*party.make_guest(9)), "The game has begun, or is full.");
}

TEST(Lockstep, AGuestWithAnotherLevelSaysSo) {
  LockstepParty party;
  lockstep::GameStart start = party.start();
  start.level_hash ^= 1;
  EXPECT_EQ(lockstep::check_files(party.setup().library, {}, kVersion, start).error().message(),
            "the game's level small is not the one here");
  start.code_hash ^= 1;
  EXPECT_EQ(lockstep::check_files(party.setup().library, {}, kVersion, start).error().message(),
            "the game's progs.dat is not the one here");
}

// On the machine's own network and clock.
TEST(Lockstep, PlaysOverUdp) {
  const auto open_socket = [] {
    auto socket = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
    CHECK(socket.ok(), "{}", socket.error().message());
    return std::move(socket).value();
  };
  const LockstepParty files;
  auto host_socket = open_socket();
  const platform::Address host = platform::ip4_address({127, 0, 0, 1}, host_socket->local_address().port);
  const auto a = lockstep::LockstepGame::host(files.setup(), files.start(), std::move(host_socket));
  const auto b = lockstep::LockstepGame::join(files.setup(), kVersion, open_socket(), host, 5);
  const auto began = std::chrono::steady_clock::now();
  const auto now_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  constexpr std::uint32_t kTicks = 50;
  while (now_s() < 30 && (a->ticks() < kTicks || b->ticks() < kTicks)) {
    a->step(now_s());
    b->step(now_s());
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_GE(a->ticks(), kTicks);
  EXPECT_GE(b->ticks(), kTicks);
  EXPECT_EQ(a->ended() + b->ended(), "");
}

TEST(Lockstep, AReplayEndsInTheSameState) {
  LockstepParty party({.players = 2, .slots = 4, .variables = {{"deathmatch", "1"}, {"bot_fill", "4"}}});
  ASSERT_TRUE(party.run_until_playing());
  play(party, 2, effort(20, 6));
  const base::ByteVector file = party.game(0).replay()->finish();
  const auto replay = lockstep::read_replay(file);
  ASSERT_TRUE(replay.ok()) << replay.error().message();
  EXPECT_EQ(replay->ticks.size(), party.game(0).ticks());
  EXPECT_EQ(replay->last_hash, party.game(0).simulation().game().state_hash());
  for (std::size_t player = 0; player < 2; ++player) {
    const auto played = lockstep::play_replay(*replay, party.setup(), kVersion, player);
    ASSERT_TRUE(played.ok()) << played.error().message();
    EXPECT_EQ(played->last_hash, replay->last_hash);
    EXPECT_GT(played->demo.size(), 10000u);
  }
  EXPECT_LT(file.size(), 20000u) << "a third of a minute, with a new move every quarter of a second";
}

TEST(Lockstep, OnePlayerNeedsNoNetwork) {
  LockstepParty party({.players = 1, .delay_ticks = 0});
  ASSERT_TRUE(party.run_until_playing());
  play(party, 1, 5);
  expect_same_games(party, 1);
  const auto replay = lockstep::read_replay(party.game(0).replay()->finish());
  ASSERT_TRUE(replay.ok()) << replay.error().message();
  const auto played = lockstep::play_replay(*replay, party.setup(), kVersion, 0);
  ASSERT_TRUE(played.ok()) << played.error().message();
  EXPECT_EQ(played->last_hash, party.game(0).simulation().game().state_hash());
}

TEST(Lockstep, AReplayOfAnotherGameNamesTheTick) {
  LockstepParty party;
  ASSERT_TRUE(party.run_until_playing());
  play(party, 2, 3);
  auto replay = lockstep::read_replay(party.game(0).replay()->finish());
  ASSERT_TRUE(replay.ok());
  const std::size_t tick = replay->ticks.size() - 20;
  for (std::size_t i = tick; i < replay->ticks.size(); ++i)
    for (net::Move& move : replay->ticks[i][0].moves) move.forward = static_cast<std::int16_t>(-move.forward);
  const auto played = lockstep::play_replay(*replay, party.setup(), kVersion, 0);
  ASSERT_FALSE(played.ok());
  EXPECT_THAT(played.error().message(), HasSubstr("the game is another one than the recorded one"));
  EXPECT_FALSE(lockstep::play_replay(*replay, party.setup(), kVersion, 2).ok());
  EXPECT_FALSE(lockstep::play_replay(*replay, party.setup(), "Temblor 0", 0).ok());
}

TEST(Lockstep, DamagedReplaysAreErrors) {
  LockstepParty party;
  ASSERT_TRUE(party.run_until_playing());
  const base::ByteVector file = party.game(0).replay()->finish();
  Random random(3);
  for (int i = 0; i < effort(300, 30); ++i) {
    base::ByteVector damaged = file;
    const std::size_t at = random.below(file.size());
    if (i % 2 == 0)
      damaged.resize(at);
    else
      damaged[at] ^= std::byte{0x11};
    static_cast<void>(lockstep::read_replay(damaged));
  }
  EXPECT_FALSE(lockstep::read_replay(base::Bytes(file).first(10)).ok());
  EXPECT_FALSE(lockstep::read_replay(base::Bytes(file).first(file.size() - 1)).ok());
}

}  // namespace
}  // namespace temblor::test
