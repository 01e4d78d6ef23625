// The stock recordings, from the first message to the last.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "net/message_reader.h"
#include "support/game_data.h"

namespace temblor::net {
namespace {

struct StockDemo {
  const char* name;
  Dialect dialect;
};

class StockDemos : public ::testing::TestWithParam<StockDemo> {};

TEST_P(StockDemos, ReadFromFirstToLastMessage) {
  DATA_FOLDER_OR_SKIP(folder);
  const base::ByteVector bytes = test::read_file(folder / "id1" / GetParam().name);
  base::ByteReader file(bytes);
  while (file.ok() && file.u8() != '\n') {
  }
  MessageReader reader;
  std::map<std::string, int> counts;
  std::string last;
  while (file.remaining() > 0) {
    const auto size = static_cast<std::size_t>(file.i32());
    file.take(12);
    const std::size_t offset = file.offset();
    reader.begin(file.take(size), offset);
    ASSERT_TRUE(file.ok());
    while (true) {
      const auto message = reader.next();
      ASSERT_TRUE(message.ok()) << message.error().message();
      if (!*message) break;
      last = name_of(**message);
      ++counts[last];
    }
  }
  EXPECT_EQ(reader.dialect(), GetParam().dialect);
  EXPECT_EQ(counts["svc_serverinfo"], 1);
  EXPECT_EQ(counts["svc_signonnum"], 3);
  EXPECT_GT(counts["svc_clientdata"], 100);
  EXPECT_GT(counts["fast update"], 100);
  EXPECT_EQ(last, "svc_disconnect");
  for (const auto& [name, count] : counts) RecordProperty(name, count);
}

INSTANTIATE_TEST_SUITE_P(Stock, StockDemos,
                         ::testing::Values(StockDemo{"demo1_lite.dem", {}}, StockDemo{"demo2_lite.dem", {}},
                                           StockDemo{"demo3_lite.dem", {}},
                                           StockDemo{"demo3.dem",
                                                     {Protocol::kRmq, kInt32Coord | kShortAngle}}),
                         [](const auto& demo) {
                           return std::string(demo.param.name, std::string_view(demo.param.name).find('.'));
                         });

}  // namespace
}  // namespace temblor::net
