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

// Puts the entry between two others, which must stay readable, and returns the reason.
std::string reason_to_leave_out(const ZipByHand& entry) {
  const auto pk3 = read_pk3(
      make_zip(std::vector<ZipByHand>{{.name = "a", .data = "one"}, entry, {.name = "b", .data = "two"}}));
  EXPECT_TRUE(pk3.ok()) << pk3.error().message();
  if (!pk3.ok()) return "";
  EXPECT_EQ(pk3->entries().size(), 2u);
  EXPECT_EQ(pk3->left_out().size(), 1u);
  if (pk3->entries().size() != 2 || pk3->left_out().size() != 1) return "";
  EXPECT_EQ(*pk3->read(0), test::to_bytes("one"));
  EXPECT_EQ(*pk3->read(1), test::to_bytes("two"));
  return pk3->left_out()[0];
}

TEST(Pk3, LeavesOutNamesThatLeaveTheFolder) {
  for (const char* name : {"../x", "/etc/passwd", "a/../../x", "..\\x", "c:\\x", "a//b", "./a", "a\nb"})
    EXPECT_THAT(reason_to_leave_out({.name = name, .data = "x"}), HasSubstr("leads outside"));
  EXPECT_THAT(reason_to_leave_out({.name = std::string("a\0b", 3), .data = "x"}), HasSubstr("leads outside"));
}

TEST(Pk3, LeavesOutEncryptedEntries) {
  EXPECT_THAT(
      reason_to_leave_out({.name = "secret", .data = std::string(20, 'x'), .flags = 1, .claimed_size = 8}),
      HasSubstr("\"secret\" is encrypted"));
}

TEST(Pk3, LeavesOutOtherCompressionMethods) {
  EXPECT_THAT(reason_to_leave_out({.name = "f", .data = "BZh91", .method = 12, .claimed_size = 5}),
              HasSubstr("compression method 12"));
}

TEST(Pk3, LeavesOutImpossibleSizes) {
  for (const ZipByHand& entry :
       {ZipByHand{.name = "f", .data = "12345678", .method = 8, .claimed_size = 8 * 1032 + 1},
        ZipByHand{.name = "f", .data = "1", .claimed_size = 0xfffffffe},
        ZipByHand{.name = "f", .data = "1", .claimed_packed_size = 0x7fffffff}})
    EXPECT_THAT(reason_to_leave_out(entry), HasSubstr("cannot come out"));
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

// DarkPlaces does not compute checksums.
TEST(Pk3, WrongChecksumIsAnErrorOnRequest) {
  const auto pk3 = read_pk3(make_zip_of_one({.name = "f", .data = "abc", .claimed_crc = 1}));
  ASSERT_TRUE(pk3.ok());
  EXPECT_EQ(*pk3->read(0), test::to_bytes("abc"));
  const auto data = pk3->read(0, Pk3::Checksum::kVerify);
  ASSERT_FALSE(data.ok());
  EXPECT_THAT(data.error().what, HasSubstr("\"f\""));
}

void expect_one_file(base::ByteVector bytes) {
  const auto pk3 = read_pk3(std::move(bytes));
  ASSERT_TRUE(pk3.ok()) << pk3.error().message();
  ASSERT_EQ(pk3->entries().size(), 1u);
  EXPECT_EQ(*pk3->read(0, Pk3::Checksum::kVerify), test::to_bytes("abc"));
}

base::ByteVector join(base::ByteVector first, const base::ByteVector& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(Pk3, BytesAroundTheArchiveAreIgnored) {
  const base::ByteVector zip = make_zip_of_one({.name = "f", .data = "abc"});
  expect_one_file(join(zip, test::to_bytes(std::string(1000, 'x'))));
  expect_one_file(join(test::to_bytes("#!/bin/sh\n"), zip));
  expect_one_file(join(base::ByteVector(70000, std::byte{7}), zip));
  const std::size_t comment_field = zip.size() - 2;
  const std::string comment = "a comment with PK\5\6 inside, which is longer than an end record";
  expect_one_file(join(test::with_number(zip, comment_field, static_cast<std::uint16_t>(comment.size())),
                       test::to_bytes(comment)));
}

// Signatures and other records may follow the directory. The place in the end record is right then.
TEST(Pk3, BytesAfterTheDirectoryAreIgnored) {
  base::ByteVector zip = make_zip_of_one({.name = "f", .data = "abc"});
  const base::ByteVector signature = test::to_bytes("PK\5\5 and a signature");
  zip.insert(zip.end() - test::kZipEndRecordBytes, signature.begin(), signature.end());
  expect_one_file(zip);
}

// Old programs wrote only the low 16 bits of the number.
TEST(Pk3, ReadsMoreRecordsThanTheEndRecordCounts) {
  const base::ByteVector zip =
      make_zip(std::vector<ZipByHand>{{.name = "a", .data = "one"}, {.name = "b", .data = "two"}});
  for (const std::uint16_t entries : {std::uint16_t{0}, std::uint16_t{1}}) {
    const auto pk3 = read_pk3(test::with_number(zip, zip.size() - test::kZipEndRecordBytes + 10, entries));
    ASSERT_TRUE(pk3.ok()) << pk3.error().message();
    EXPECT_EQ(pk3->entries().size(), 2u);
    EXPECT_TRUE(pk3->left_out().empty());
  }
}

TEST(Pk3, ReportsUnreadableRecords) {
  base::ByteVector zip =
      make_zip(std::vector<ZipByHand>{{.name = "a", .data = "one"}, {.name = "b", .data = "two"}});
  // The mark of the second directory record, which is the last thing before the end record.
  const std::size_t second = zip.size() - test::kZipEndRecordBytes - 47;
  const auto pk3 = read_pk3(test::with_number(zip, second, 0u));
  ASSERT_TRUE(pk3.ok()) << pk3.error().message();
  ASSERT_EQ(pk3->entries().size(), 1u);
  EXPECT_EQ(*pk3->read(0), test::to_bytes("one"));
  ASSERT_EQ(pk3->left_out().size(), 1u);
  EXPECT_THAT(pk3->left_out()[0], HasSubstr("1 record of the directory"));
}

TEST(Pk3, DamagedLocalHeaderFailsOnRead) {
  const base::ByteVector zip =
      make_zip(std::vector<ZipByHand>{{.name = "a", .data = "one"}, {.name = "b", .data = "two"}});
  constexpr std::size_t kLocalNameField = 26;
  for (const base::ByteVector& bytes :
       {test::with_number(zip, 0, 0u), test::with_number(zip, kLocalNameField, 0xffffffffu)}) {
    const auto pk3 = read_pk3(bytes);
    ASSERT_TRUE(pk3.ok()) << pk3.error().message();
    const auto damaged = pk3->read(0);
    ASSERT_FALSE(damaged.ok());
    EXPECT_THAT(damaged.error().what, HasSubstr("\"a\": its data is not in the archive"));
    EXPECT_EQ(*pk3->read(1), test::to_bytes("two"));
  }
}

TEST(Pk3, KeepsBothFilesOfOneName) {
  const auto pk3 =
      read_pk3(make_zip(std::vector<ZipByHand>{{.name = "a", .data = "old"}, {.name = "a", .data = "new"}}));
  ASSERT_TRUE(pk3.ok());
  ASSERT_EQ(pk3->entries().size(), 2u);
  EXPECT_EQ(*pk3->read(0), test::to_bytes("old"));
  EXPECT_EQ(*pk3->read(1), test::to_bytes("new"));
}

// The zip64 records of an archive with one directory record.
base::ByteVector with_zip64(const base::ByteVector& zip, std::uint64_t entries, std::uint64_t extra_bytes) {
  base::ByteReader end(zip);
  const std::size_t end_record = zip.size() - test::kZipEndRecordBytes;
  end.seek(end_record + test::kZipEndDirectorySizeField);
  const std::uint32_t size = end.u32(), offset = end.u32();
  base::ByteWriter writer;
  writer.bytes(base::Bytes(zip).first(end_record));
  writer.u32(0x06064b50);
  writer.write<std::uint64_t>(44);  // bytes of this record after the field
  writer.u16(45);                   // version made by, version needed
  writer.u16(45);
  writer.u32(0);  // disks
  writer.u32(0);
  writer.write(entries);
  writer.write(entries);
  writer.write<std::uint64_t>(size + extra_bytes);
  writer.write<std::uint64_t>(offset);
  writer.u32(0x07064b50);
  writer.u32(0);  // disk
  writer.write<std::uint64_t>(end_record);
  writer.u32(1);  // disks
  writer.bytes(base::Bytes(zip).subspan(end_record));
  return std::move(writer).take();
}

TEST(Pk3, ReadsZip64) {
  base::ByteVector zip = with_zip64(make_zip_of_one({.name = "f", .data = "abc"}), 1, 0);
  expect_one_file(zip);
  // The same, with all numbers of the end record in the zip64 record.
  const std::size_t end_record = zip.size() - test::kZipEndRecordBytes;
  for (const std::size_t field : {8u, 10u})
    zip = test::with_number(zip, end_record + field, std::uint16_t{0xffff});
  for (const std::size_t field : {12u, 16u}) zip = test::with_number(zip, end_record + field, 0xffffffffu);
  expect_one_file(zip);
}

TEST(Pk3, ReadsZip64AfterOtherBytes) {
  expect_one_file(join(base::ByteVector(70000, std::byte{7}),
                       with_zip64(make_zip_of_one({.name = "f", .data = "abc"}), 1, 0)));
}

// Sizes and offset of a record in its zip64 field, as programs write them that do not know the size in
// advance.
TEST(Pk3, ReadsZip64FieldsOfRecords) {
  constexpr std::size_t kExtraField = 30, kRecordBytes = 46;
  const base::ByteVector plain = make_zip_of_one({.name = "f", .data = "abc"});
  const std::size_t end_record = plain.size() - test::kZipEndRecordBytes;
  const std::size_t directory = end_record - kRecordBytes - 1;
  base::ByteWriter writer;
  writer.bytes(base::Bytes(plain).first(end_record));
  writer.u16(0x7075);  // another field before it
  writer.u16(2);
  writer.u16(0);
  writer.u16(1);
  writer.u16(3 * 8);
  writer.write<std::uint64_t>(3);  // bytes unpacked
  writer.write<std::uint64_t>(3);  // bytes packed
  writer.write<std::uint64_t>(0);  // offset of the local header
  const auto extra_bytes = static_cast<std::uint16_t>(writer.size() - end_record);
  writer.patch(directory + kExtraField, extra_bytes);
  for (const std::size_t field : {20u, 24u, 42u}) writer.patch(directory + field, 0xffffffffu);
  writer.bytes(base::Bytes(plain).subspan(end_record));
  writer.patch(end_record + extra_bytes + test::kZipEndDirectorySizeField,
               static_cast<std::uint32_t>(kRecordBytes + 1 + extra_bytes));
  expect_one_file(std::move(writer).take());
}

TEST(Pk3, RejectsHugeZip64DirectoryBeforeParsing) {
  const base::ByteVector zip = make_zip_of_one({.name = "f", .data = "abc"});
  expect_refused(with_zip64(zip, 1, 0x7fffffff), base::ErrorCode::kTooLarge, "directory of");
  expect_refused(with_zip64(zip, std::uint64_t{1} << 40, 0), base::ErrorCode::kMalformed, "do not fit");
}

TEST(Pk3, RejectsHugeDirectoryBeforeParsing) {
  base::ByteVector bytes((std::size_t{32} << 20) + 1000);
  const base::ByteVector valid = make_zip_of_one({.name = "f", .data = "abc"});
  bytes.insert(bytes.end(), valid.begin(), valid.end());
  const std::size_t field = bytes.size() - test::kZipEndRecordBytes + test::kZipEndDirectorySizeField;
  expect_refused(test::with_number(bytes, field, (32u << 20) + 1), base::ErrorCode::kTooLarge,
                 "directory of");
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
      const auto data = pk3->read(k, Pk3::Checksum::kVerify);
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
  EXPECT_FALSE(write_pk3(std::vector<ArchiveFile>(65536, ArchiveFile{"a", {}})).ok());
}

}  // namespace
}  // namespace temblor::formats
