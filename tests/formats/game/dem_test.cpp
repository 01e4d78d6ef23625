#include "formats/game/dem.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "support/game_data.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

struct Record {
  math::Vec3 angles_deg{0.0f};
  base::ByteVector message;
  std::size_t offset = 0;
};
struct Recording {
  int forced_track = 0;
  std::vector<Record> records;
  bool is_truncated = false;
  std::string error;  // empty: none
};

// Reads a recording to its end or to an error.
Recording play(base::Bytes bytes) {
  Recording recording;
  auto reader = DemReader::open(bytes);
  if (!reader.ok()) return {0, {}, false, reader.error().what};
  recording.forced_track = reader->forced_track();
  while (true) {
    const auto message = reader->next();
    if (!message.ok()) {
      recording.error = message.error().what;
      EXPECT_EQ(reader->next().error().what, recording.error);  // the error persists
      break;
    }
    if (!*message) break;
    const DemMessage& found = **message;
    recording.records.push_back(
        {found.view_angles_deg, {found.message.begin(), found.message.end()}, found.offset});
    EXPECT_EQ(reader->offset(), found.offset + found.message.size());
  }
  recording.is_truncated = reader->is_truncated();
  EXPECT_EQ(reader->size(), bytes.size());
  EXPECT_EQ(reader->offset() == bytes.size(), !recording.is_truncated && recording.error.empty());
  return recording;
}

// A demo with track 2 and the messages "ab" and "".
base::ByteVector hand_made_recording() {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("2\n"));
  writer.i32(2);
  for (const float angle : {10.0f, -20.0f, 30.5f}) writer.f32(angle);
  writer.bytes(base::as_bytes("ab"));
  writer.i32(0);
  for (const float angle : {1.0f, 2.0f, 3.0f}) writer.f32(angle);
  return std::move(writer).take();
}
constexpr std::size_t kFirstAt = 2, kSecondAt = 2 + 16 + 2;

TEST(Dem, ReadsHandMadeFile) {
  const Recording recording = play(hand_made_recording());
  EXPECT_EQ(recording.error, "");
  EXPECT_FALSE(recording.is_truncated);
  EXPECT_EQ(recording.forced_track, 2);
  ASSERT_EQ(recording.records.size(), 2u);
  EXPECT_EQ(recording.records[0].angles_deg, math::Vec3(10, -20, 30.5));
  EXPECT_EQ(recording.records[0].message, test::to_bytes("ab"));
  EXPECT_EQ(recording.records[0].offset, kFirstAt + 16);
  EXPECT_EQ(recording.records[1].angles_deg, math::Vec3(1, 2, 3));
  EXPECT_TRUE(recording.records[1].message.empty());
}

TEST(Dem, RoundTrips) {
  const Recording recording = play(hand_made_recording());
  DemWriter writer(recording.forced_track);
  for (const Record& record : recording.records) writer.add(record.angles_deg, record.message);
  EXPECT_EQ(std::move(writer).take(), hand_made_recording());
}

TEST(Dem, AcceptsMessagesUpToLimit) {
  DemWriter writer;
  const base::ByteVector longest(kMaxDemMessage, std::byte{7});
  writer.add({0, 0, 0}, longest);
  const Recording recording = play(std::move(writer).take());
  EXPECT_EQ(recording.forced_track, -1);
  ASSERT_EQ(recording.records.size(), 1u);
  EXPECT_EQ(recording.records[0].message, longest);
}

// QuakeSpasm or DarkPlaces plays demos with all of these lines.
TEST(Dem, ReadsFirstLine) {
  EXPECT_EQ(play(base::as_bytes("-1\n")).forced_track, -1);
  for (const char* line : {"12\r\n", "12 \n", " \t12\n", "+12\n", "00000000000000000000000012\n"})
    EXPECT_EQ(play(base::as_bytes(line)).forced_track, 12) << line;
  for (const char* line : {"\n", "\r\n", "-\n", "2 3\n", "99999999999\n", "x\n", "12abc\n", "my demo\n"}) {
    EXPECT_EQ(play(base::as_bytes(line)).error, "") << line;
    EXPECT_EQ(play(base::as_bytes(line)).forced_track, -1) << line;
  }
  for (const std::string& line :
       {std::string(), std::string("2"), std::string("\x01\n"), std::string("x\xff\n"),
        std::string("\0\n", 2), std::string(100, ' ') + "2\n"})
    EXPECT_THAT(play(base::as_bytes(line)).error, HasSubstr("not a demo")) << line;
}

TEST(Dem, TruncatedDemoKeepsWholeRecords) {
  test::for_each_truncation(hand_made_recording(), [](const base::ByteVector& bytes) {
    const Recording recording = play(bytes);
    if (bytes.size() < kFirstAt) {
      EXPECT_THAT(recording.error, HasSubstr("not a demo"));
      return;
    }
    EXPECT_EQ(recording.error, "") << bytes.size();
    EXPECT_EQ(recording.records.size(), bytes.size() >= kSecondAt ? 1u : 0u) << bytes.size();
    EXPECT_EQ(recording.is_truncated, bytes.size() != kFirstAt && bytes.size() != kSecondAt) << bytes.size();
  });
}

TEST(Dem, RejectsLengthsOutOfRange) {
  for (const std::int32_t length :
       {-1, static_cast<std::int32_t>(kMaxDemMessage) + 1, std::numeric_limits<std::int32_t>::min()}) {
    const Recording recording = play(test::with_number(hand_made_recording(), kSecondAt, length));
    EXPECT_EQ(recording.records.size(), 1u);
    EXPECT_FALSE(recording.is_truncated);
    EXPECT_EQ(recording.error,
              fmt::format("message at offset 20: size of {} bytes exceeds the limit of 65536", length));
  }
}

TEST(Dem, AnglesNeedNotBeFinite) {
  for (const float angle :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    const Recording recording = play(test::with_number(hand_made_recording(), kSecondAt + 8, angle));
    EXPECT_EQ(recording.error, "");
    ASSERT_EQ(recording.records.size(), 2u);
    EXPECT_EQ(recording.records[1].angles_deg, math::Vec3(1, 0, 3));
  }
}

TEST(Dem, StockDemosRoundTrip) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"demo1_lite.dem", "demo2_lite.dem", "demo3_lite.dem", "demo3.dem"}) {
    SCOPED_TRACE(name);
    const base::ByteVector bytes = test::read_file(data / "id1" / name);
    const Recording recording = play(bytes);
    EXPECT_EQ(recording.error, "");
    EXPECT_FALSE(recording.is_truncated);
    EXPECT_GT(recording.records.size(), 100u);
    ASSERT_FALSE(recording.records.empty());
    EXPECT_EQ(recording.records.back().message, test::to_bytes("\x02"));  // disconnect
    DemWriter writer(recording.forced_track);
    for (const Record& record : recording.records) writer.add(record.angles_deg, record.message);
    EXPECT_EQ(std::move(writer).take(), bytes);
  }
}

}  // namespace
}  // namespace temblor::formats
