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
      ASSERT_LE(entry.name.size(), kPakNameChars);
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
    ::testing::Values(
        HostilePak{"Magic", 0, 0x4b434151, "PACK"},
        HostilePak{"DirectoryOffsetNegative", 4, -1, "outside of the file"},
        HostilePak{"DirectoryOffsetPastEnd", 4, 18, "outside of the file"},
        HostilePak{"DirectorySizeNegative", 8, -64, "outside of the file"},
        HostilePak{"DirectorySizeHuge", 8, 0x7fffffc0, "outside of the file"},
        HostilePak{"DirectorySizeUneven", 8, 65, "not a multiple of the entry size"},
        HostilePak{"EntryOffsetNegative", kFirstRecord + kOffsetField, -2, "entry 0 \"maps/ab\""},
        HostilePak{"EntryOffsetPastEnd", kFirstRecord + kOffsetField, 146, "entry 0 \"maps/ab\""},
        HostilePak{"EntrySizeNegative", kFirstRecord + kSizeField, -1, "entry 0 \"maps/ab\""},
        HostilePak{"EntrySizeHuge", kFirstRecord + kSizeField, 0x7fffffff, "outside of the file"},
        HostilePak{"SecondEntry", kFirstRecord + 64 + kSizeField, 200, "entry 1 \"c\""}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Pak, RejectsUnterminatedName) {
  base::ByteVector bytes = hand_made_pak();
  for (std::size_t i = 0; i < 56; ++i) bytes[kFirstRecord + i] = std::byte{'n'};
  const auto entries = read_pak(bytes);
  ASSERT_FALSE(entries.ok());
  EXPECT_THAT(entries.error().what, HasSubstr("name is not terminated"));
}

TEST(Pak, ErrorsAreOneLine) {
  const auto bytes = write_pak(std::vector<ArchiveFile>{{"a\nb\x1b[31m\xff", base::as_bytes("1234")}});
  ASSERT_TRUE(bytes.ok());
  const auto entries = read_pak(test::with_number(*bytes, 16 + kSizeField, std::int32_t{1000}));
  ASSERT_FALSE(entries.ok());
  EXPECT_THAT(entries.error().what, HasSubstr("\"a?b?[31m?\""));
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
