// Reads and rewrites every message of the stock demos.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "net/protocol/dem_packets.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_text.h"
#include "net/protocol/message_writer.h"
#include "support/game_data.h"

namespace temblor::net {
namespace {

struct StockDemo {
  const char* name;
  Dialect dialect;
  // Its server sent an ideal pitch of 0 explicitly, although that is the default.
  bool has_needless_bytes = false;
};

class StockDemos : public ::testing::TestWithParam<StockDemo> {
 protected:
  static base::ByteVector read(const std::filesystem::path& folder) {
    return test::read_file(folder / "id1" / GetParam().name);
  }
};

TEST_P(StockDemos, ReadFromFirstToLastMessage) {
  DATA_FOLDER_OR_SKIP(folder);
  const base::ByteVector bytes = read(folder);
  MessageReader reader;
  std::map<std::string, int> counts;
  std::string last;
  for (const test::DemPacket& packet : test::dem_packets(bytes)) {
    reader.begin(packet.bytes, packet.offset);
    while (true) {
      const auto message = reader.next();
      ASSERT_TRUE(message.ok()) << message.error().message();
      if (!*message) break;
      last = message_name(**message);
      ++counts[last];
    }
  }
  EXPECT_EQ(reader.dialect(), GetParam().dialect);
  EXPECT_EQ(counts["svc_serverinfo"], 1);
  EXPECT_EQ(counts["svc_signonnum"], 3);
  EXPECT_EQ(counts["svc_lightstyle"], 64);
  EXPECT_GT(counts["svc_time"], 1000);
  EXPECT_EQ(counts["svc_clientdata"], counts["svc_time"]);
  EXPECT_GE(counts["fast update"], counts["svc_time"]);
  EXPECT_EQ(last, "svc_disconnect");
}

// Our writer reproduces the messages of stock servers byte for byte.
TEST_P(StockDemos, RewrittenBytesAreIdentical) {
  DATA_FOLDER_OR_SKIP(folder);
  const base::ByteVector bytes = read(folder);
  MessageReader reader, reader_of_written;
  for (const test::DemPacket& packet : test::dem_packets(bytes)) {
    reader.begin(packet.bytes, packet.offset);
    base::ByteWriter written;
    std::string text;
    while (const auto message = reader.next().value()) {
      ASSERT_TRUE(write_message(*message, reader.dialect(), written).ok());
      text += test::get_text(*message) + '\n';
    }
    if (!GetParam().has_needless_bytes) {
      ASSERT_TRUE(std::ranges::equal(written.view(), packet.bytes)) << "offset " << packet.offset;
    }
    std::string text_of_written;
    reader_of_written.begin(written.view());
    while (const auto message = reader_of_written.next().value())
      text_of_written += test::get_text(*message) + '\n';
    ASSERT_EQ(text_of_written, text) << "offset " << packet.offset;
  }
}

INSTANTIATE_TEST_SUITE_P(Stock, StockDemos,
                         ::testing::Values(StockDemo{"demo1_lite.dem", {}, true},
                                           StockDemo{"demo2_lite.dem", {}}, StockDemo{"demo3_lite.dem", {}},
                                           StockDemo{"demo3.dem",
                                                     {Protocol::kRmq, kInt32Coord | kShortAngle}}),
                         [](const auto& demo) {
                           return std::string(demo.param.name, std::string_view(demo.param.name).find('.'));
                         });

}  // namespace
}  // namespace temblor::net
