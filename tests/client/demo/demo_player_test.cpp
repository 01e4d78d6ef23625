// Demos built message by message, played back.
#include "client/demo/demo_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "client/demo/demo_builder.h"
#include "client/session/messages.h"
#include "support/mutations.h"

namespace temblor::test {
namespace {

using client::ClientSettings;
using client::DemoPlayer;
using testing::ElementsAre;
using testing::HasSubstr;

DemoPlayer play(base::ByteVector demo) {
  return DemoPlayer::open(std::move(demo), "test.dem").value();
}

// Signon, then a packet every 1/16 s from 1 s on; the player moves by 8 units with each packet.
DemoBuilder walk(int packets) {
  DemoBuilder demo;
  demo.signon(server_info());
  for (int i = 0; i < packets; ++i)
    demo.packet(1 + static_cast<float>(i) / 16, {update_at(1, kPlayerModel, {8 * i, 0, 0})},
                {0, static_cast<float>(10 * i), 0});
  return demo;
}

float player_x(DemoPlayer& io_player) {
  return io_player.state().interpolate_entities(io_player.server_time_s(), {}).front().origin_world.x;
}
float yaw_deg(const DemoPlayer& player, const ClientSettings& settings = {}) {
  return player.view_angles_at(player.server_time_s(), settings).y;
}

TEST(DemoPlayer, ReadsUntilTheTimeIsNotPastTheLastPacket) {
  DemoPlayer player = play(walk(5).bytes());
  ASSERT_TRUE(player.advance_to(0).value());
  EXPECT_EQ(player.packet_time_s(), 1) << "through the signon to the first entities";
  EXPECT_EQ(player.server_time_s(), 1);
  ASSERT_TRUE(player.advance_to(1.0625).value());
  EXPECT_EQ(player.packet_time_s(), 1.0625);
  EXPECT_EQ(player_x(player), 8);
  ASSERT_TRUE(player.advance_to(1.078125).value());
  EXPECT_EQ(player.packet_time_s(), 1.125);
  EXPECT_EQ(player_x(player), 10);
  EXPECT_EQ(yaw_deg(player), 12.5f);
  EXPECT_EQ(yaw_deg(player, {.interpolate = false, .no_lerp_models = {}}), 20);
  ASSERT_TRUE(player.advance_to(1.25).value()) << "several packets in one call";
  EXPECT_EQ(player_x(player), 32);
  EXPECT_FALSE(player.advance_to(1.3).value());
  EXPECT_EQ(player.server_time_s(), 1.25) << "the last state stays";
  EXPECT_EQ(player_x(player), 32);
  EXPECT_FALSE(player.advance_to(1.4).value());
  EXPECT_FALSE(player.is_truncated());
}

TEST(DemoPlayer, ReadsOneRecordAtATime) {
  DemoPlayer player = play(walk(3).bytes());
  for (const double time_s : {1.0, 1.0625, 1.125}) {
    ASSERT_TRUE(player.read_packet().value());
    EXPECT_EQ(player.packet_time_s(), time_s);
    EXPECT_EQ(player.server_time_s(), time_s);
  }
  EXPECT_FALSE(player.read_packet().value());
  EXPECT_FALSE(player.read_packet().value());
}

TEST(DemoPlayer, WorksAfterAMove) {
  DemoPlayer first = play(walk(3).bytes());
  ASSERT_TRUE(first.read_packet().value());
  DemoPlayer second = std::move(first);
  ASSERT_TRUE(second.read_packet().value());
  EXPECT_EQ(player_x(second), 8);
}

TEST(DemoPlayer, TurnsTheShorterWay) {
  DemoBuilder demo;
  demo.signon(server_info());
  demo.packet(1, {update_at(1, kPlayerModel, {})}, {0, 350, 0});
  demo.packet(1.0625f, {update_at(1, kPlayerModel, {})}, {0, 10, 0});
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.advance_to(1.015625).value());
  EXPECT_EQ(yaw_deg(player), 355);
}

TEST(DemoPlayer, TurnsAtOnceWhereTheServerTurnsOrMovesThePlayer) {
  DemoBuilder demo = walk(2);
  // The record has the angles from when the packet arrived.
  demo.packet(1.125f, {net::SetAngle{{0, 90, 0}}, update_at(1, kPlayerModel, {16, 0, 0})}, {0, 20, 0});
  demo.packet(1.1875f, {update_at(1, kPlayerModel, {24, 0, 0})}, {0, 110, 0});
  demo.packet(1.25f, {update_at(1, kPlayerModel, {1000, 0, 0})}, {0, 270, 0});
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.advance_to(1.0625).value());
  ASSERT_TRUE(player.advance_to(1.078125).value());
  EXPECT_EQ(yaw_deg(player), 90);
  ASSERT_TRUE(player.advance_to(1.15625).value());
  EXPECT_EQ(yaw_deg(player), 100);
  ASSERT_TRUE(player.advance_to(1.203125).value());
  EXPECT_EQ(yaw_deg(player), 270);
}

TEST(DemoPlayer, RecordsWithoutATimeDoNotStopIt) {
  DemoBuilder demo = walk(2);
  demo.record({net::Print{"one\n"}}, {0, 77, 0});
  demo.record({net::Print{"two\n"}}, {0, 77, 0});
  demo.packet(1.125f, {update_at(1, kPlayerModel, {16, 0, 0})}, {0, 20, 0});
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.advance_to(1.09375).value());
  EXPECT_THAT(player.state().events().prints, ElementsAre("one\n", "two\n"));
  EXPECT_EQ(player_x(player), 12);
  EXPECT_EQ(yaw_deg(player), 15) << "interpolated from packet to packet";
}

TEST(DemoPlayer, RecordsWithoutATimeDoNotTurnTimeBack) {
  DemoBuilder demo = walk(2);
  demo.record({net::StuffText{"bf\n"}});
  demo.packet(1.125f, {update_at(1, kPlayerModel, {16, 0, 0})});
  DemoPlayer player = play(demo.bytes());
  std::vector<double> times_s;
  while (player.begin_packet().value()) times_s.push_back(player.server_time_s());
  // The first packet, the start of the second, the end of the second with the text, the start of the third.
  ASSERT_TRUE(player.state().events().bonus_flashes == 1);
  EXPECT_THAT(times_s, ElementsAre(1, 1, 1.0625, 1.0625));
}

TEST(DemoPlayer, TheClockContinuesThroughLevelChanges) {
  DemoBuilder demo = walk(3);
  net::ServerInfo second = server_info();
  const std::array<std::string_view, 1> models = {"maps/e1m1.bsp"};
  second.models = models;
  demo.signon(second);
  demo.packet(101, {update_at(1, 1, {})});
  demo.packet(101.0625f, {update_at(1, 1, {})});
  const base::ByteVector bytes = demo.bytes();
  const auto length = DemoPlayer::scan(bytes, "test.dem").value();
  EXPECT_EQ(length.packets, 5u);
  EXPECT_EQ(length.first_time_s, 1);
  EXPECT_EQ(length.last_time_s, 1.1875);
  EXPECT_THAT(length.levels, ElementsAre("maps/start.bsp", "maps/e1m1.bsp"));
  EXPECT_FALSE(length.damage);

  DemoPlayer player = play(bytes);
  ASSERT_TRUE(player.advance_to(1.125).value());
  EXPECT_EQ(player.server_time_s(), 1.125);
  player.state().events().clear();
  ASSERT_TRUE(player.advance_to(1.15625).value());
  EXPECT_TRUE(player.state().events().new_level);
  EXPECT_EQ(player.packet_time_s(), 1.1875);
  EXPECT_EQ(player.server_time_s(), 101.03125);
}

// Lag, a pause and a clock set back: each packet takes 0.1 s at most.
TEST(DemoPlayer, TheClockDoesNotWaitOutGaps) {
  DemoBuilder demo = walk(1);
  for (const float time_s : {3.0f, 3.0f, 16777216.0f, 2.0f, 2.0625f})
    demo.packet(time_s, {update_at(1, kPlayerModel, {})});
  const auto length = DemoPlayer::scan(demo.bytes(), "test.dem").value();
  EXPECT_EQ(length.packets, 6u);
  EXPECT_NEAR(length.last_time_s, 1 + 0.1 + 0 + 0.1 + 0 + 0.0625, 1e-9);
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.advance_to(1.05).value());
  EXPECT_NEAR(player.server_time_s(), 2.95, 1e-9);
  EXPECT_NEAR(player.packet_time_s(), 1.1, 1e-9);
}

TEST(DemoPlayer, ADisconnectEndsTheDemo) {
  DemoBuilder demo = walk(2);
  demo.record({net::Disconnect{}});
  demo.packet(1.125f, {update_at(1, kPlayerModel, {})});
  const auto length = DemoPlayer::scan(demo.bytes(), "test.dem").value();
  EXPECT_EQ(length.packets, 2u);
}

TEST(DemoPlayer, ATruncatedFilePlaysItsWholeRecords) {
  base::ByteVector bytes = walk(4).bytes();
  bytes.pop_back();
  const auto length = DemoPlayer::scan(bytes, "test.dem").value();
  EXPECT_EQ(length.packets, 3u);
  EXPECT_TRUE(length.is_truncated);
  DemoPlayer player = play(bytes);
  EXPECT_TRUE(player.advance_to(1.125).value());
  EXPECT_FALSE(player.advance_to(1.13).value());
  EXPECT_TRUE(player.is_truncated());
  EXPECT_EQ(player_x(player), 16);
}

// A text, then the name of a player in slot 99, which does not exist.
TEST(DemoPlayer, DamageIsReportedOnceAndEarlierMessagesCount) {
  DemoBuilder demo = walk(2);
  constexpr std::size_t kLengthAndAngles = 16, kText = 4;
  const std::string offset = std::to_string(demo.bytes().size() + kLengthAndAngles + kText);
  demo.record({net::Print{"a\n"}, net::UpdateName{99, "Ranger"}});
  demo.packet(1.125f, {update_at(1, kPlayerModel, {})});
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.advance_to(1.0625).value());
  const auto damaged = player.advance_to(1.1);
  ASSERT_FALSE(damaged.ok());
  EXPECT_THAT(damaged.error().message(), HasSubstr("test.dem: offset " + offset + ": svc_updatename: "));
  EXPECT_THAT(player.state().events().prints, ElementsAre("a\n"));
  EXPECT_EQ(player_x(player), 8);
  EXPECT_FALSE(player.advance_to(1.1).value());
  EXPECT_FALSE(player.read_packet().value());

  const auto length = DemoPlayer::scan(demo.bytes(), "test.dem").value();
  EXPECT_EQ(length.packets, 2u);
  ASSERT_TRUE(length.damage);
  EXPECT_EQ(length.damage->message(), damaged.error().message());
}

// A damaged packet does not remove the entities that it had not named yet.
TEST(DemoPlayer, DamageInAPacketKeepsTheEntitiesOfTheLastOne) {
  DemoBuilder demo;
  demo.signon(server_info());
  const auto first = update_at(1, kPlayerModel, {}), second = update_at(2, kOgreModel, {});
  demo.packet(1, {first, second});
  demo.packet(1.0625f, {first, net::UpdateFrags{200, 0}, second});
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.read_packet().value());
  ASSERT_FALSE(player.read_packet().ok());
  EXPECT_EQ(player.state().interpolate_entities(player.server_time_s(), {}).size(), 2u);
}

TEST(DemoPlayer, PlaysOnAfterAnUnknownMessage) {
  DemoBuilder demo;
  demo.signon(server_info());
  const auto first = update_at(1, kPlayerModel, {}), second = update_at(2, kOgreModel, {});
  demo.packet(1, {first, second});
  demo.packet(1.0625f, "\143?");
  demo.packet(1.125f, {first, second});
  DemoPlayer player = play(demo.bytes());
  ASSERT_TRUE(player.read_packet().value());
  ASSERT_TRUE(player.read_packet().value());
  EXPECT_THAT(player.state().events().notes,
              ElementsAre(HasSubstr("message 99: unknown message (after svc_time)")));
  EXPECT_EQ(player.state().interpolate_entities(player.server_time_s(), {}).size(), 2u);
  EXPECT_EQ(DemoPlayer::scan(demo.bytes(), "test.dem").value().packets, 3u);
}

TEST(DemoPlayer, NothingToShowIsAnError) {
  const auto no_demo = DemoPlayer::open(to_bytes("PACK"), "x.dem");
  ASSERT_FALSE(no_demo.ok());
  EXPECT_THAT(no_demo.error().message(), HasSubstr("x.dem: "));
  EXPECT_FALSE(DemoPlayer::scan(to_bytes("PACK"), "x.dem").ok());
  const auto empty = DemoPlayer::scan(walk(0).bytes(), "x.dem");
  ASSERT_FALSE(empty.ok());
  EXPECT_THAT(empty.error().message(), HasSubstr("x.dem: the demo ends before its game begins"));
  DemoPlayer player = play(walk(0).bytes());
  EXPECT_FALSE(player.advance_to(0).value());
  EXPECT_TRUE(player.state().interpolate_entities(0, {}).empty());
}

// At any truncation all complete packets are played, and nothing else happens.
TEST(DemoPlayer, EveryTruncationPlaysToItsEnd) {
  const base::ByteVector whole = walk(3).bytes();
  std::size_t most = 0;
  for_each_truncation(whole, [&](const base::ByteVector& bytes) {
    auto player = DemoPlayer::open(bytes, "cut.dem");
    if (!player.ok()) return;
    std::size_t packets = 0;
    auto read = player->read_packet();
    for (; read.ok() && *read; read = player->read_packet()) ++packets;
    EXPECT_TRUE(read.ok()) << bytes.size();
    EXPECT_GE(packets, most);
    EXPECT_LE(packets, most + 1);
    most = packets;
  });
  EXPECT_EQ(most, 2u);
}

}  // namespace
}  // namespace temblor::test
