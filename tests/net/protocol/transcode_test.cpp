// Demos converted to other protocols contain the same messages.
#include "support/programs/transcode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "formats/game/dem.h"
#include "net/protocol/dem_packets.h"
#include "net/protocol/dialects.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_text.h"
#include "support/game_data.h"

namespace temblor::net {
namespace {

using test::k15;
using test::k666;
using test::k999;

// The text of every message, packet by packet; ServerInfo without its dialect.
std::vector<std::string> list_texts(base::Bytes dem, Dialect& out_dialect) {
  std::vector<std::string> texts;
  MessageReader reader;
  for (const test::DemPacket& packet : test::dem_packets(dem)) {
    reader.begin(packet.bytes, packet.offset);
    while (auto message = reader.next().value()) {
      if (auto* info = std::get_if<ServerInfo>(&*message)) info->dialect = {};
      texts.push_back(test::get_text(*message));
    }
    texts.push_back("end of packet");
  }
  out_dialect = reader.dialect();
  return texts;
}

// Eighths of a unit and 256ths of a turn are exact in all three, so nothing may differ.
TEST(Transcode, DemoOfProtocol15IsSameIn666And999) {
  DATA_FOLDER_OR_SKIP(folder);
  for (const char* name : {"demo1_lite.dem", "demo2_lite.dem"}) {
    const base::ByteVector original = test::read_file(folder / "id1" / name);
    Dialect dialect;
    const std::vector<std::string> texts = list_texts(original, dialect);
    ASSERT_EQ(dialect, k15);
    for (const Dialect& to : {k666, k999}) {
      const auto transcoded = test::transcode(original, to);
      ASSERT_TRUE(transcoded.ok()) << transcoded.error().message();
      EXPECT_TRUE(list_texts(*transcoded, dialect) == texts) << name << " in protocol " << int(to.protocol);
      EXPECT_EQ(dialect, to);
    }
  }
}

TEST(Transcode, RoundTripIsIdentical) {
  DATA_FOLDER_OR_SKIP(folder);
  for (const char* name : {"demo2_lite.dem", "demo3_lite.dem"}) {
    const base::ByteVector original = test::read_file(folder / "id1" / name);
    const auto there = test::transcode(original, k666);
    ASSERT_TRUE(there.ok()) << there.error().message();
    const auto back = test::transcode(*there, k15);
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_TRUE(*back == original) << name;
  }
}

// Sixteenths of a unit round to eighths, 65536ths of a turn to 256ths.
TEST(Transcode, DemoOfProtocol999IsRoundedIn666) {
  DATA_FOLDER_OR_SKIP(folder);
  const base::ByteVector original = test::read_file(folder / "id1/demo3.dem");
  const auto transcoded = test::transcode(original, k666);
  ASSERT_TRUE(transcoded.ok()) << transcoded.error().message();
  const auto packets = test::dem_packets(original), transcoded_packets = test::dem_packets(*transcoded);
  ASSERT_EQ(packets.size(), transcoded_packets.size());
  MessageReader reader, transcoded_reader;
  int updates = 0;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    reader.begin(packets[i].bytes);
    transcoded_reader.begin(transcoded_packets[i].bytes);
    while (auto message = reader.next().value()) {
      const auto other = transcoded_reader.next().value();
      ASSERT_TRUE(other && other->index() == message->index()) << "packet " << i;
      const auto* update = std::get_if<EntityUpdate>(&*message);
      if (update == nullptr) continue;
      const auto& rounded = std::get<EntityUpdate>(*other);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(update->origin[axis].has_value(), rounded.origin[axis].has_value());
        ASSERT_EQ(update->angles_deg[axis].has_value(), rounded.angles_deg[axis].has_value());
        ASSERT_NEAR(update->origin[axis].value_or(0), rounded.origin[axis].value_or(0), 1 / 16.0);
        const float turned = update->angles_deg[axis].value_or(0) - rounded.angles_deg[axis].value_or(0);
        ASSERT_LE(std::abs(std::remainder(turned, 360)), 360 / 512.0 + 1e-4);
      }
      ++updates;
    }
    ASSERT_FALSE(transcoded_reader.next().value().has_value());
  }
  EXPECT_GT(updates, 1000);
}

TEST(Transcode, NamesOffsetOfUnreadableMessage) {
  formats::DemWriter recording;
  const std::string_view nop("\1", 1), unknown("\1\115", 2);
  recording.add({1, 2, 3}, base::as_bytes(nop));
  recording.add({1, 2, 3}, base::as_bytes(unknown));
  const auto transcoded = test::transcode(std::move(recording).take(), k666);
  ASSERT_FALSE(transcoded.ok());
  // After "-1\n", two lengths with three angles each, and two nops.
  EXPECT_EQ(transcoded.error().message(), "offset 37: message 77: unknown message (after svc_nop)");
}

}  // namespace
}  // namespace temblor::net
