#include "formats/archives/pak.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

// Written field by field from the description of the format: two files, "ab" and "c", of 3 and 2 bytes.
base::ByteVector hand_made_pak() {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("PACK"));
  writer.i32(17);      // directory offset
  writer.i32(2 * 64);  // directory bytes
  writer.bytes(base::as_bytes("XYZpq"));
  writer.fixed_text("maps/ab", 56);
  writer.i32(12);
  writer.i32(3);
  writer.fixed_text("c", 56);
  writer.i32(15);
  writer.i32(2);
  return std::move(writer).take();
}

constexpr std::size_t kFirstRecord = 17;
constexpr std::size_t kOffsetField = 56;
constexpr std::size_t kSizeField = 60;

TEST(Pak, ReadsHandMadeArchive) {
  const base::ByteVector bytes = hand_made_pak();
  const auto entries = read_pak(bytes);
  ASSERT_TRUE(entries.ok()) << entries.error().message();
  EXPECT_EQ(*entries, (std::vector<PakEntry>{{"maps/ab", 12, 3}, {"c", 15, 2}}));
}

TEST(Pak, WritesTheSameBytes) {
  const auto bytes =
      write_pak(std::vector<ArchiveFile>{{"maps/ab", base::as_bytes("XYZ")}, {"c", base::as_bytes("pq")}});
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*bytes, hand_made_pak());
}

TEST(Pak, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    std::vector<base::ByteVector> contents(random.below(20));
    std::vector<ArchiveFile> files;
    for (base::ByteVector& content : contents) {
      content = test::random_bytes(random, random.below(300));
      std::string name(random.below(kPakNameChars + 1), 'x');
      for (char& c : name) c = static_cast<char>(1 + random.below(255));
      files.push_back({name, content});
    }
    const auto bytes = write_pak(files);
    ASSERT_TRUE(bytes.ok()) << "seed " << seed;
    const auto entries = read_pak(*bytes);
    ASSERT_TRUE(entries.ok()) << "seed " << seed << ": " << entries.error().message();
    ASSERT_EQ(entries->size(), files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
      const PakEntry& entry = (*entries)[i];
      EXPECT_EQ(entry.name, files[i].name) << "seed " << seed;
      const base::ByteVector data(bytes->begin() + static_cast<std::ptrdiff_t>(entry.offset),
                                  bytes->begin() + static_cast<std::ptrdiff_t>(entry.offset + entry.size));
      EXPECT_EQ(data, contents[i]) << "seed " << seed;
    }
  }
}

TEST(Pak, RejectsEveryTruncation) {
  test::for_each_truncation(hand_made_pak(), [](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_pak(bytes).ok()) << bytes.size() << " bytes";
  });
}

TEST(Pak, FlippedBitsStayInBounds) {
  const base::ByteVector valid = hand_made_pak();
  test::Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const base::ByteVector damaged = test::with_flipped_bits(valid, random);
    const auto entries = read_pak(damaged);
    if (!entries.ok()) continue;
    for (const PakEntry& entry : *entries) {
      ASSERT_LE(entry.name.size(), kPakNameChars + 1);
      ASSERT_LE(entry.offset, damaged.size());
      ASSERT_LE(entry.size, damaged.size() - entry.offset);
    }
  }
}

struct HostilePak {
  const char* name;
  std::size_t offset;
  std::int32_t value;
  const char* message;
};

class HostilePakTest : public ::testing::TestWithParam<HostilePak> {};

TEST_P(HostilePakTest, IsRejected) {
  const auto entries = read_pak(test::with_number(hand_made_pak(), GetParam().offset, GetParam().value));
  ASSERT_FALSE(entries.ok());
  EXPECT_THAT(entries.error().message(), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Pak, HostilePakTest,
    ::testing::Values(HostilePak{"Magic", 0, 0x4b434151, "PACK"},
                      HostilePak{"DirectoryOffsetNegative", 4, -1, "outside of the file"},
                      HostilePak{"DirectoryOffsetPastEnd", 4, 18, "outside of the file"},
                      HostilePak{"DirectorySizeNegative", 8, -64, "outside of the file"},
                      HostilePak{"DirectorySizeHuge", 8, 0x7fffffc0, "outside of the file"}),
    [](const auto& test) { return std::string(test.param.name); });

std::vector<std::string> names_in(base::Bytes bytes) {
  std::vector<std::string> names;
  const auto entries = read_pak(bytes);
  EXPECT_TRUE(entries.ok()) << entries.error().message();
  for (const PakEntry& entry : *entries) names.push_back(entry.name);
  return names;
}

TEST(Pak, IgnoresBytesAfterTheLastWholeRecord) {
  const std::vector<std::string> both = {"maps/ab", "c"};
  for (const std::int32_t size : {129, 191})
    EXPECT_EQ(names_in(test::with_number(hand_made_pak(), 8, size)), both);
  EXPECT_FALSE(read_pak(test::with_number(hand_made_pak(), 8, 192)).ok());
}

// A game may never open such a file.
TEST(Pak, IgnoresEntriesOutsideOfTheFile) {
  const std::vector<std::string> only_first = {"maps/ab"}, only_second = {"c"};
  for (const std::int32_t offset : {-2, 146, 0x7fffffff})
    EXPECT_EQ(names_in(test::with_number(hand_made_pak(), kFirstRecord + kOffsetField, offset)), only_second);
  for (const std::int32_t size : {-1, 200, 0x7fffffff}) {
    EXPECT_EQ(names_in(test::with_number(hand_made_pak(), kFirstRecord + kSizeField, size)), only_second);
    EXPECT_EQ(names_in(test::with_number(hand_made_pak(), kFirstRecord + 64 + kSizeField, size)), only_first);
  }
}

TEST(Pak, IgnoresAnIncompleteEntry) {
  const std::vector<std::string> only_first = {"maps/ab"};
  EXPECT_EQ(names_in(test::with_number(hand_made_pak(), 8, std::int32_t{65})), only_first);
  EXPECT_EQ(names_in(test::with_number(hand_made_pak(), 8, std::int32_t{127})), only_first);
}

TEST(Pak, ReadsNamesWithoutZero) {
  base::ByteVector bytes = hand_made_pak();
  for (std::size_t i = 0; i < 56; ++i) bytes[kFirstRecord + i] = std::byte{'n'};
  EXPECT_EQ(names_in(bytes), (std::vector<std::string>{std::string(56, 'n'), "c"}));
}

TEST(Pak, KeepsRepeatedNames) {
  const auto bytes = write_pak(std::vector<ArchiveFile>{
      {"a", base::as_bytes("1")}, {"a", base::as_bytes("22")}, {"A", base::Bytes{}}});
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(names_in(*bytes), (std::vector<std::string>{"a", "a", "A"}));
}

TEST(Pak, RejectsTooManyEntriesBeforeReading) {
  const std::uint64_t directory_bytes = (kMaxPakEntries + 1) * kPakRecordBytes;
  base::ByteWriter header;
  header.bytes(base::as_bytes("PACK"));
  header.i32(12);
  header.i32(static_cast<std::int32_t>(directory_bytes));
  const auto read = read_pak_header(header.view(), 12 + directory_bytes);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, base::ErrorCode::kTooLarge);
}

TEST(Pak, WriteRejectsWhatDoesNotFit) {
  const std::string longest(kPakNameChars, 'n');
  EXPECT_TRUE(write_pak(std::vector<ArchiveFile>{{longest, {}}}).ok());
  EXPECT_FALSE(write_pak(std::vector<ArchiveFile>{{longest + 'n', {}}}).ok());
  const base::ByteVector block(std::size_t{1} << 20);
  EXPECT_FALSE(write_pak(std::vector<ArchiveFile>(2048, {"f", block})).ok());  // 2^31 bytes
}

}  // namespace
}  // namespace temblor::formats
