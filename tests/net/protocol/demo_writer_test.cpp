#include "net/protocol/demo_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "formats/game/dem.h"

namespace temblor::net {
namespace {

using ::testing::ElementsAre;

std::vector<base::ByteVector> list_messages(base::Bytes recording) {
  auto reader = formats::DemReader::open(recording);
  CHECK(reader.ok(), "{}", reader.error().message());
  std::vector<base::ByteVector> messages;
  for (auto next = reader->next(); next.ok() && *next; next = reader->next())
    messages.emplace_back((*next)->message.begin(), (*next)->message.end());
  return messages;
}

const base::ByteVector kNopMessage(1, std::byte{1}), kNopMessages(2, std::byte{1});
const base::ByteVector kEnd(1, std::byte{2});  // svc_disconnect

TEST(DemoWriter, WritesMessagesAndEnd) {
  DemoWriter recording;
  EXPECT_TRUE(recording.is_empty());
  recording.add({1, 2, 3}, kNopMessages);
  recording.add({1, 2, 3}, kNopMessage);
  EXPECT_FALSE(recording.is_empty());
  const base::ByteVector bytes = std::move(recording).finish();
  EXPECT_THAT(list_messages(bytes), ElementsAre(kNopMessages, kNopMessage, kEnd));
}

TEST(DemoWriter, SkipsEmptyAndOversizedPackets) {
  DemoWriter recording;
  recording.add({0, 0, 0}, {});
  recording.add({0, 0, 0}, base::ByteVector(formats::kMaxStockDemMessage + 1, std::byte{1}));
  EXPECT_TRUE(recording.is_empty());
  const base::ByteVector bytes = std::move(recording).finish();
  EXPECT_THAT(list_messages(bytes), ElementsAre(kEnd));
}

TEST(DemoWriter, FullDemoStillEnds) {
  DemoWriter recording;
  const base::ByteVector longest(formats::kMaxStockDemMessage, std::byte{1});
  std::size_t added = 0;
  for (; !recording.is_full(); ++added) recording.add({0, 0, 0}, longest);
  recording.add({0, 0, 0}, kNopMessage);
  const base::ByteVector bytes = std::move(recording).finish();
  auto reader = formats::DemReader::open(bytes);
  ASSERT_TRUE(reader.ok());
  std::size_t read = 0;
  base::Bytes last;
  for (auto next = reader->next(); next.ok() && *next; next = reader->next(), ++read) last = (*next)->message;
  EXPECT_EQ(read, added + 1);
  EXPECT_EQ(base::ByteVector(last.begin(), last.end()), kEnd);
}

}  // namespace
}  // namespace temblor::net
