// A server survives game code, clients and networks that misbehave.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "client/demo/demo_player.h"
#include "client_server/served_game.h"
#include "net/protocol/message_writer.h"
#include "support/effort.h"
#include "support/mutations.h"
#include "support/programs/quakec.h"
#include "support/random.h"
#include "vfs/disk.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace field = server::field;

TEST(HostileProgram, ValuesOutOfRangeDoNotEndTheServer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(), {.max_clients = 1});
  const std::size_t me = served.add_client("rich");
  ASSERT_TRUE(served.run_until_playing(me));
  const server::Edict player = served.game().player(0);
  const float no_number = std::numeric_limits<float>::quiet_NaN();
  player.set(field::kAmmoShells, 300.0f);
  player.set(field::kArmorValue, 1e9f);
  player.set(field::kItems, no_number);
  player.set(field::kAngles, math::Vec3{no_number});
  player.set(field::kFixAngle, 1.0f);
  player.set(field::kPunchAngle, math::Vec3{no_number});
  player.set(field::kViewOffset, math::Vec3{0, 0, std::numeric_limits<float>::infinity()});
  served.game().machine().set_global_float(server::global::kServerFlags, no_number);
  served.run(0.5);
  const std::uint64_t updates = served.client(me).updates();
  served.command("save rich; load rich");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
  EXPECT_GT(served.client(me).updates(), updates);
  // Stock servers send the lower eight bits.
  EXPECT_EQ(served.client(me).state().game().data.shells, 300 & 255);
}

// An unreliable and a reliable message with unknown numbers, in packets with others.
TEST(HostileProgram, MessagesThatTheClientDoesNotKnowDoNotEndTheGame) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(R"(
    void(entity e, string s) clientcommand = #440;
    void(string s) SV_ParseClientCommand = {
      if (s != "boo") { clientcommand(self, s); return; }
      WriteByte(0, 99);
      WriteByte(2, 100);
    };
  )"));
  const std::size_t me = served.add_client("patient");
  ASSERT_TRUE(served.run_until_playing(me));
  for (int i = 0; i < 3; ++i) {
    served.client(me).send_command("boo");
    served.run(0.3);
  }
  const std::uint64_t updates = served.client(me).updates();
  served.run(1);
  ASSERT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
  EXPECT_GT(served.client(me).updates(), updates);
  const std::string& printed = served.prints(me);
  const std::size_t note = printed.find("unknown message (");
  ASSERT_NE(note, std::string::npos) << printed;
  EXPECT_EQ(printed.find("unknown message (", note + 1), std::string::npos) << "once in a level";
}

TEST(HostileProgram, CommandsThatItPassesOnRunWhenItHasReturned) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(R"(
    void(entity e, string s) clientcommand = #440;
    void(string s) SV_ParseClientCommand = { clientcommand(self, s); };
  )"));
  const std::size_t me = served.add_client("admin");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("rcon_password secret");
  served.run(0.1);
  served.game().player(0).set(field::kHealth, 50.0f);
  served.client(me).send_command("rcon secret map small");
  served.run(3);
  ASSERT_TRUE(served.client(me).is_playing()) << served.client(me).disconnect_reason();
  EXPECT_EQ(served.game().player(0)[field::kHealth], 100);
}

TEST(HostileProgram, APlayerWhoMakesItFailTwiceIsDroppedAndOthersStay) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(R"(
    void() deep = { deep(); };
    void(string s) SV_ParseClientCommand = { if (s == "crash") { deep(); } };
  )"));
  const std::size_t bad = served.add_client("bad"), good = served.add_client("good");
  ASSERT_TRUE(served.run_until_playing(bad));
  ASSERT_TRUE(served.run_until_playing(good));
  for (int i = 0; i < 3; ++i) {
    served.client(bad).send_command("crash");
    served.run(2);
  }
  EXPECT_FALSE(served.client(bad).is_playing());
  EXPECT_TRUE(served.client(good).is_playing()) << served.console();
  EXPECT_THAT(served.console(), HasSubstr("client bad (10.0.0."));
  EXPECT_THAT(served.console(), HasSubstr("removed: game code failed twice for it"));
}

TEST(HostileProgram, UnknownClassesAreSkippedAndReported) {
  SKIP_WITHOUT_QUAKEC();
  std::string program = small_program();
  const std::size_t at = program.find("void() light =");
  ASSERT_NE(at, std::string::npos);
  program.replace(at, std::string_view("void() light =").size(), "void() lamp =");
  ServedGame served(program);
  EXPECT_THAT(served.console(), HasSubstr("there is no function \"light\""));
  EXPECT_TRUE(served.run_until_playing(served.add_client("tester")));
}

TEST(HostileProgram, MoreEntitiesThanProtocol15CanNumberUseTheNextProtocol) {
  SKIP_WITHOUT_QUAKEC();
  const std::string many = small_program(R"(
    void() crowd = {
      local float i; local entity e;
      i = 0;
      while (i < 700) { e = spawn(); setmodel(e, "*1"); i = i + 1; }
    };
  )");
  std::string program = many;
  program.replace(program.find("lightstyle(1"), 0, "crowd(); ");
  ServedGame served(program);
  EXPECT_EQ(served.game().setup().dialect.protocol, net::Protocol::kFitzQuake);
  EXPECT_TRUE(served.run_until_playing(served.add_client("tester")));
}

TEST(HostileClient, RandomBytesHarmNobodyElse) {
  SKIP_WITHOUT_QUAKEC();
  for (std::uint64_t seed = 0; seed < std::uint64_t{effort(6, 2)}; ++seed) {
    ServedGame served(small_program(), {.seed = seed + 1});
    const std::size_t good = served.add_client("good");
    ASSERT_TRUE(served.run_until_playing(good));
    Random random(seed);
    std::vector<std::unique_ptr<platform::DatagramSocket>> attackers;
    for (std::uint8_t i = 0; i < 20; ++i)
      attackers.push_back(served.network().open(platform::ip4_address({10, 0, 9, i}, 666)));
    for (int i = 0; i < 200; ++i) {
      for (const auto& attacker : attackers) {
        base::ByteVector bytes = random_bytes(random, random.below(1400));
        // In many cases with a valid header.
        if (bytes.size() >= 8 && random.chance(0.5)) {
          bytes[0] = std::byte{0};
          bytes[1] = static_cast<std::byte>(random.below(2) == 0 ? 0x01 : 0x10);
          bytes[2] = static_cast<std::byte>(bytes.size() >> 8);
          bytes[3] = static_cast<std::byte>(bytes.size() & 255);
        }
        attacker->send(kServedAddress, bytes);
      }
      served.run(0.02);
    }
    EXPECT_TRUE(served.client(good).is_playing()) << "seed " << seed;
    served.client(good).send_command("say still here");
    served.run(1);
    EXPECT_THAT(served.prints(good), HasSubstr("still here"));
  }
}

TEST(HostileClient, FloodsOfCommandsEndTheConnection) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t bad = served.add_client("bad"), good = served.add_client("good");
  ASSERT_TRUE(served.run_until_playing(bad));
  ASSERT_TRUE(served.run_until_playing(good));
  for (int i = 0; i < 500; ++i) served.client(bad).send_command("say spam");
  served.run(5);
  EXPECT_FALSE(served.client(bad).is_playing());
  EXPECT_TRUE(served.client(good).is_playing());
  EXPECT_THAT(served.console(), HasSubstr("too many commands"));
}

TEST(HostileClient, NamesAndChatStayOnOneLine) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t bad = served.add_client("a\nb\x01\x02 and a very long name indeed");
  ASSERT_TRUE(served.run_until_playing(bad));
  EXPECT_EQ(served.server().clients[0].name, "ab and a very l");
  served.client(bad).send_command("say hello\x01\x03there");
  served.run(1);
  EXPECT_THAT(served.console(), HasSubstr("hellothere"));
}

TEST(BadNetworkServer, NobodyIsDroppedInTenMinutesOfLoss) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served(small_program(),
                    {.max_clients = 4,
                     .conditions = {.loss = 0.2, .duplication = 0.05, .delay_s = 0.15, .jitter_s = 0.075}});
  std::vector<std::size_t> players;
  for (int i = 0; i < 3; ++i) players.push_back(served.add_client(fmt::format("p{}", i)));
  served.run(30);
  for (const std::size_t player : players)
    ASSERT_TRUE(served.client(player).is_playing()) << served.client(player).disconnect_reason();
  const std::uint64_t before = served.client(0).updates();
  constexpr double kSeconds = effort(600, 60);
  served.run(kSeconds, {.angles_deg = {0, 45, 0}, .forward = 100});
  for (const std::size_t player : players) EXPECT_TRUE(served.client(player).is_playing());
  // Four of five datagrams arrive, and those that arrive out of order are ignored.
  const double share = static_cast<double>(served.client(0).updates() - before) / (kSeconds * 72);
  EXPECT_GT(share, 0.25);
  EXPECT_LT(share, 0.85);
  served.client(0).send_command("say the end");
  served.run(10);
  for (const std::size_t player : players) EXPECT_THAT(served.prints(player), HasSubstr("the end"));
}

TEST(ServedRecording, EndsWithTheLevelAndContainsTheMessagesToOnePlayer) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("star");
  ASSERT_TRUE(served.run_until_playing(me));
  served.command("record film");
  served.run(0.5);
  served.client(me).send_command("status");  // only this player gets the answer
  served.client(me).send_command("say for all");
  served.run(1);
  served.command("changelevel small");
  served.run(3);
  EXPECT_THAT(served.console(), HasSubstr("Demo saved: "));
  const auto bytes = vfs::read_disk_file(served.folder().path() / "id1/film.dem");
  ASSERT_TRUE(bytes.ok());
  auto player = client::DemoPlayer::open(*bytes, "film");
  ASSERT_TRUE(player.ok()) << player.error().message();
  std::string prints;
  for (auto goes_on = player->read_packet(); goes_on.ok() && *goes_on; goes_on = player->read_packet()) {
    for (const std::string& text : player->state().events().prints) prints += text;
    player->state().events().clear();
  }
  EXPECT_THAT(prints, HasSubstr("players: 1 active"));
  EXPECT_THAT(prints, HasSubstr("for all"));
}

}  // namespace
}  // namespace temblor::test
