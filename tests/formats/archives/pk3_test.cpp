#include "formats/archives/pk3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "support/effort.h"
#include "support/mutations.h"
#include "support/programs/zip_by_hand.h"

namespace temblor::formats {
namespace {

using test::make_zip;
using test::ZipByHand;
using ::testing::HasSubstr;

base::ByteVector make_zip_of_one(const ZipByHand& entry) {
  return make_zip(std::vector<ZipByHand>{entry});
}

TEST(Pk3, ReadsHandMadeArchive) {
  const auto pk3 = read_pk3(make_zip(std::vector<ZipByHand>{
      {.name = "maps/", .data = ""}, {.name = "maps/a.bsp", .data = "level"}, {.name = "b", .data = ""}}));
  ASSERT_TRUE(pk3.ok()) << pk3.error().message();
  ASSERT_EQ(pk3->entries().size(), 2u);
  EXPECT_EQ(pk3->entries()[0].name, "maps/a.bsp");
  EXPECT_EQ(pk3->entries()[0].size, 5u);
  EXPECT_EQ(pk3->entries()[1].name, "b");
  EXPECT_EQ(*pk3->read(0), test::to_bytes("level"));
  EXPECT_EQ(*pk3->read(1), base::ByteVector{});
}

TEST(Pk3, UnpacksADeflatedEntry) {
  // Deflated data (RFC 1951): one final stored block of 3 bytes.
  const std::string deflated(
      "\x01\x03\x00\xfc\xff"
      "abc",
      8);
  const auto pk3 = read_pk3(make_zip_of_one(
      {.name = "f", .data = deflated, .method = 8, .claimed_size = 3, .claimed_crc = 0x352441c2}));
  ASSERT_TRUE(pk3.ok()) << pk3.error().message();
  const auto data = pk3->read(0);
  ASSERT_TRUE(data.ok()) << data.error().message();
  EXPECT_EQ(*data, test::to_bytes("abc"));
}

TEST(Pk3, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    test::Random random(seed);
    std::vector<base::ByteVector> contents(1 + random.below(12));
    std::vector<ArchiveFile> files;
    for (base::ByteVector& content : contents) {
      content = test::random_bytes(random, random.below(3000));
      if (random.chance(0.5)) content.assign(random.below(60000), std::byte{'z'});  // packs well
      files.push_back({"folder/" + std::to_string(files.size()) + ".dat", content});
    }
    auto bytes = write_pk3(files);
    ASSERT_TRUE(bytes.ok()) << "seed " << seed << ": " << bytes.error().message();
    EXPECT_EQ(*bytes, *write_pk3(files)) << "seed " << seed;
    const auto pk3 = read_pk3(std::move(bytes).value());
    ASSERT_TRUE(pk3.ok()) << "seed " << seed << ": " << pk3.error().message();
    ASSERT_EQ(pk3->entries().size(), files.size());
    for (std::size_t i = files.size(); i-- > 0;) {
      EXPECT_EQ(pk3->entries()[i].name, files[i].name);
      const auto data = pk3->read(i);
      ASSERT_TRUE(data.ok()) << data.error().message();
      EXPECT_EQ(*data, contents[i]) << "seed " << seed << " file " << i;
    }
  }
}

TEST(Pk3, StaysReadableWhenMoved) {
  auto first = read_pk3(make_zip_of_one({.name = "a", .data = "one"}));
  auto second = read_pk3(make_zip_of_one({.name = "b", .data = "two"}));
  ASSERT_TRUE(first.ok() && second.ok());
  Pk3 pk3 = std::move(first).value();
  EXPECT_EQ(*pk3.read(0), test::to_bytes("one"));
  pk3 = std::move(second).value();
  EXPECT_EQ(*pk3.read(0), test::to_bytes("two"));
}

TEST(Pk3, IsThreadSafe) {
  std::vector<ZipByHand> entries;
  for (int i = 0; i < 50; ++i)
    entries.push_back({.name = std::to_string(i), .data = std::string(1000, char('0' + i))});
  const auto pk3 = read_pk3(make_zip(entries));
  ASSERT_TRUE(pk3.ok());
  std::array<int, 4> right{};
  std::vector<std::thread> threads;
  for (int& count : right)
    threads.emplace_back([&] {
      for (std::size_t i = 0; i < entries.size(); ++i)
        count += *pk3->read(i) == test::to_bytes(entries[i].data) ? 1 : 0;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(right, ::testing::Each(50));
}

void expect_refused(base::ByteVector bytes, base::ErrorCode code, const char* message) {
  SCOPED_TRACE(message);
  const auto pk3 = read_pk3(std::move(bytes));
  ASSERT_FALSE(pk3.ok());
  EXPECT_EQ(pk3.error().code, code);
  EXPECT_THAT(pk3.error().what, HasSubstr(message));
}

TEST(Pk3, RejectsNamesThatLeaveFolder) {
  for (const char* name : {"../x", "/etc/passwd", "a/../../x", "..\\x", "c:\\x", "a//b", "./a", "a\nb"})
    expect_refused(make_zip_of_one({.name = name, .data = "x"}), base::ErrorCode::kMalformed,
                   "leads outside");
}

TEST(Pk3, RejectsEncryptedEntries) {
  expect_refused(
      make_zip_of_one({.name = "secret", .data = std::string(20, 'x'), .flags = 1, .claimed_size = 8}),
      base::ErrorCode::kUnsupported, "\"secret\" is encrypted");
}

TEST(Pk3, RejectsOtherCompressionMethods) {
  expect_refused(make_zip_of_one({.name = "f", .data = "BZh91", .method = 12, .claimed_size = 5}),
                 base::ErrorCode::kUnsupported, "compression method 12");
}

TEST(Pk3, RejectsImpossibleSizes) {
  expect_refused(
      make_zip_of_one({.name = "f", .data = "12345678", .method = 8, .claimed_size = 8 * 1032 + 1}),
      base::ErrorCode::kMalformed, "cannot come out");
  expect_refused(make_zip_of_one({.name = "f", .data = "1", .claimed_size = 0xfffffffe}),
                 base::ErrorCode::kMalformed, "cannot come out");
  expect_refused(make_zip_of_one({.name = "f", .data = "1", .claimed_packed_size = 0x7fffffff}),
                 base::ErrorCode::kMalformed, "cannot come out");
}

TEST(Pk3, RejectsZipBombByTotalSize) {
  // Sixteen entries that each claim the maximum that 64 KiB can unpack to, 67 MB: just over 1 GiB.
  const std::string packed(1 << 16, 'x');
  std::vector<ZipByHand> entries;
  for (int i = 0; i < 16; ++i)
    entries.push_back({.name = std::to_string(i), .data = packed, .method = 8, .claimed_size = 1032u << 16});
  expect_refused(make_zip(entries), base::ErrorCode::kTooLarge, "unpacks to more than 1073741824 bytes");
  entries.pop_back();
  EXPECT_TRUE(read_pk3(make_zip(entries)).ok());
}

TEST(Pk3, LimitIsConfigurable) {
  const base::ByteVector bytes =
      make_zip(std::vector<ZipByHand>{{.name = "a", .data = "12345"}, {.name = "b", .data = "678"}});
  EXPECT_TRUE(read_pk3(bytes, {.unpacked_bytes = 8}).ok());
  EXPECT_FALSE(read_pk3(bytes, {.unpacked_bytes = 7}).ok());
}

TEST(Pk3, RejectsEntryLargerThanDeclared) {
  const base::ByteVector zeros(100000);
  const auto bytes = write_pk3(std::vector<ArchiveFile>{{"zeros", zeros}});
  ASSERT_TRUE(bytes.ok());
  // The size is 24 bytes after the start of the directory record, whose offset is in the end record.
  base::ByteReader reader(*bytes);
  reader.seek(bytes->size() - 6);
  const std::size_t directory = reader.u32();
  const auto pk3 = read_pk3(test::with_number(*bytes, directory + 24, std::uint32_t{50000}));
  if (!pk3.ok()) return;  // an error at once is fine too
  EXPECT_FALSE(pk3->read(0).ok());
}

TEST(Pk3, RejectsWrongChecksum) {
  const auto pk3 = read_pk3(make_zip_of_one({.name = "f", .data = "abc", .claimed_crc = 1}));
  ASSERT_TRUE(pk3.ok());
  const auto data = pk3->read(0);
  ASSERT_FALSE(data.ok());
  EXPECT_THAT(data.error().what, HasSubstr("\"f\""));
}

TEST(Pk3, RejectsHugeDirectoryBeforeParsing) {
  const base::ByteVector valid = make_zip_of_one({.name = "f", .data = "abc"});
  const std::size_t field = valid.size() - test::kZipEndRecordBytes + test::kZipEndDirectorySizeField;
  expect_refused(test::with_number(valid, field, 0x7fffffffu), base::ErrorCode::kTooLarge, "directory of");
}

TEST(Pk3, Zip64IsRejected) {
  base::ByteVector bytes = make_zip_of_one({.name = "f", .data = "abc"});
  const base::ByteVector locator = test::to_bytes(std::string("PK\6\7") + std::string(16, '\0'));
  bytes.insert(bytes.end() - test::kZipEndRecordBytes, locator.begin(), locator.end());
  expect_refused(bytes, base::ErrorCode::kUnsupported, "zip64");
}

TEST(Pk3, RejectsEveryTruncation) {
  const base::ByteVector valid =
      make_zip(std::vector<ZipByHand>{{.name = "maps/a.bsp", .data = "level"}, {.name = "b", .data = "xyz"}});
  test::for_each_truncation(valid, [](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_pk3(bytes).ok()) << bytes.size() << " bytes";
  });
}

TEST(Pk3, FlippedBitsFailOrKeepBytes) {
  const base::ByteVector content(2000, std::byte{'q'});
  const auto valid = write_pk3(std::vector<ArchiveFile>{{"a", content}, {"b", base::as_bytes("xyz")}});
  ASSERT_TRUE(valid.ok());
  test::Random random(4);
  for (int i = 0; i < test::effort(5000, 1000); ++i) {
    const auto pk3 = read_pk3(test::with_flipped_bits(*valid, random));
    if (!pk3.ok()) continue;
    for (std::size_t k = 0; k < pk3->entries().size(); ++k) {
      const auto data = pk3->read(k);
      if (!data.ok() || data->empty()) continue;
      // The checksum does not protect names, dates, and similar fields.
      EXPECT_TRUE(*data == content || *data == test::to_bytes("xyz")) << "damage " << i;
    }
  }
}

TEST(Pk3, WriteRejectsInvalidFiles) {
  EXPECT_FALSE(write_pk3({}).ok());
  EXPECT_FALSE(write_pk3(std::vector<ArchiveFile>{{"../a", {}}}).ok());
  EXPECT_FALSE(write_pk3(std::vector<ArchiveFile>{{"a", {}}, {"a", {}}}).ok());
}

}  // namespace
}  // namespace temblor::formats
