#include "formats/archives/wad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text.h"
#include "formats/images/picture.h"
#include "formats/images/wad_texture.h"
#include "support/game_data.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kRecord = 17;  // of hand_made_wad()

// Written field by field from the description of the format: one lump "Logo" of 5 bytes, type 66.
base::ByteVector hand_made_wad() {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("WAD2"));
  writer.i32(1);
  writer.i32(kRecord);
  writer.bytes(base::as_bytes("hello"));
  writer.i32(12);  // offset
  writer.i32(5);   // bytes stored
  writer.i32(5);   // bytes
  writer.u8(66);
  writer.u8(0);
  writer.u16(0);
  writer.fixed_text("Logo", 16);
  return std::move(writer).take();
}

TEST(Wad, ReadsHandMadeFile) {
  const base::ByteVector bytes = hand_made_wad();
  const auto lumps = read_wad(bytes);
  ASSERT_TRUE(lumps.ok()) << lumps.error().message();
  ASSERT_EQ(lumps->size(), 1u);
  EXPECT_EQ((*lumps)[0].name, "Logo");
  EXPECT_EQ((*lumps)[0].type, kWadPicture);
  EXPECT_EQ(base::as_text((*lumps)[0].data), "hello");
}

TEST(Wad, WritesTheSameBytes) {
  const auto bytes = write_wad(std::vector<WadLump>{{"Logo", kWadPicture, base::as_bytes("hello")}});
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*bytes, hand_made_wad());
}

TEST(Wad, ReadsWad3) {
  const base::ByteVector bytes = test::with_number(hand_made_wad(), 0, std::uint32_t{0x33444157});
  EXPECT_TRUE(is_wad3(bytes));
  EXPECT_FALSE(is_wad3(hand_made_wad()));
  const auto lumps = read_wad(bytes);
  ASSERT_TRUE(lumps.ok()) << lumps.error().message();
  EXPECT_EQ(base::as_text(lumps->at(0).data), "hello");
}

TEST(Wad, FindsFirstLumpIgnoringCase) {
  const std::vector<WadLump> lumps{{"A", 1, {}}, {"b", 2, {}}, {"B", 3, {}}};
  EXPECT_EQ(find_lump(lumps, "B"), &lumps[1]);
  EXPECT_EQ(find_lump(lumps, "a"), &lumps[0]);
  EXPECT_EQ(find_lump(lumps, "c"), nullptr);
}

TEST(Wad, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    std::vector<base::ByteVector> contents(random.below(20));
    std::vector<WadLump> lumps;
    for (base::ByteVector& content : contents) {
      content = test::random_bytes(random, random.below(300));
      std::string name(random.below(kWadNameChars + 1), 'x');
      for (char& c : name) c = static_cast<char>(1 + random.below(255));
      lumps.push_back({name, static_cast<std::uint8_t>(random.below(256)), content});
    }
    const auto bytes = write_wad(lumps);
    ASSERT_TRUE(bytes.ok()) << "seed " << seed;
    const auto read = read_wad(*bytes);
    ASSERT_TRUE(read.ok()) << "seed " << seed << ": " << read.error().message();
    ASSERT_EQ(read->size(), lumps.size());
    for (std::size_t i = 0; i < lumps.size(); ++i) {
      EXPECT_EQ((*read)[i].name, lumps[i].name) << "seed " << seed;
      EXPECT_EQ((*read)[i].type, lumps[i].type) << "seed " << seed;
      EXPECT_EQ(base::as_text((*read)[i].data), base::as_text(contents[i])) << "seed " << seed;
    }
  }
}

TEST(Wad, RejectsEveryTruncation) {
  test::for_each_truncation(hand_made_wad(), [](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_wad(bytes).ok()) << bytes.size() << " bytes";
  });
}

TEST(Wad, FlippedBitsStayInBounds) {
  const base::ByteVector valid = hand_made_wad();
  test::Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const base::ByteVector damaged = test::with_flipped_bits(valid, random);
    const auto lumps = read_wad(damaged);
    if (!lumps.ok()) continue;
    for (const WadLump& lump : *lumps) {
      if (lump.data.empty()) continue;
      ASSERT_GE(lump.data.data(), damaged.data());
      ASSERT_LE(lump.data.data() + lump.data.size(), damaged.data() + damaged.size());
    }
  }
}

template <typename T>
void expect_refused(std::size_t offset, T value, const char* message) {
  SCOPED_TRACE(message);
  const base::ByteVector bytes = test::with_number(hand_made_wad(), offset, value);
  const auto lumps = read_wad(bytes);
  ASSERT_FALSE(lumps.ok());
  EXPECT_THAT(lumps.error().message(), HasSubstr(message));
}

TEST(Wad, RejectsHostileNumbers) {
  expect_refused(0, std::uint32_t{0x34444157}, "WAD2");  // "WAD4"
  expect_refused(4, std::int32_t{-1}, "-1 lumps");
  expect_refused(4, std::int32_t{2}, "2 lumps");
  expect_refused(4, std::int32_t{0x7fffffff}, "outside of the file");
  expect_refused(8, std::int32_t{-1}, "offset -1");
  expect_refused(8, std::int32_t{18}, "outside of the file");
}

// A game may never use such a lump.
TEST(Wad, EmptiesLumpsThatBeginOutside) {
  const base::ByteVector valid = hand_made_wad();
  for (const std::int32_t offset : {-1, static_cast<std::int32_t>(valid.size())}) {
    const base::ByteVector bytes = test::with_number(valid, kRecord, offset);
    const auto lumps = read_wad(bytes);
    ASSERT_TRUE(lumps.ok()) << lumps.error().message();
    ASSERT_EQ(lumps->size(), 1u);
    EXPECT_EQ(lumps->at(0).name, "Logo");
    EXPECT_TRUE(lumps->at(0).data.empty());
  }
}

// Other engines look neither at the two sizes nor at the compression.
TEST(Wad, SizesAndCompressionMayBeWrong) {
  const base::ByteVector valid = hand_made_wad();
  const std::size_t size = read_wad(valid)->at(0).data.size();
  for (const std::size_t place : {kRecord + 4, kRecord + 8})
    for (const std::int32_t wrong : {-5, 0, 1, 1000}) {
      const auto lumps = read_wad(test::with_number(valid, place, wrong));
      ASSERT_TRUE(lumps.ok()) << lumps.error().message();
      EXPECT_EQ(lumps->at(0).data.size(), size) << wrong;
    }
  const base::ByteVector neither =
      test::with_number(test::with_number(valid, kRecord + 4, -5), kRecord + 8, 1000);
  EXPECT_GE(read_wad(neither)->at(0).data.size(), size);
  EXPECT_EQ(read_wad(test::with_number(valid, kRecord + 13, std::uint8_t{1}))->at(0).data.size(), size);
}

TEST(Wad, MayHaveBytesAfterTheTable) {
  base::ByteVector bytes = hand_made_wad();
  bytes.resize(bytes.size() + 13);
  const auto lumps = read_wad(bytes);
  ASSERT_TRUE(lumps.ok()) << lumps.error().message();
  EXPECT_EQ(lumps->size(), 1u);
}

TEST(Wad, WriteRejectsWhatDoesNotFit) {
  EXPECT_TRUE(write_wad(std::vector<WadLump>{{std::string(16, 'n'), 0, {}}}).ok());
  EXPECT_FALSE(write_wad(std::vector<WadLump>{{std::string(17, 'n'), 0, {}}}).ok());
  const base::ByteVector block(std::size_t{1} << 20);
  EXPECT_FALSE(write_wad(std::vector<WadLump>(2048, {"f", 0, block})).ok());  // 2^31 bytes
}

// Every lump of the stock WADs: pictures and textures decode, and encode to the same bytes.
void check_stock_wad(const std::filesystem::path& path) {
  SCOPED_TRACE(path.string());
  const base::ByteVector bytes = test::read_file(path);
  const auto lumps = read_wad(bytes);
  ASSERT_TRUE(lumps.ok()) << lumps.error().message();
  ASSERT_FALSE(lumps->empty());
  for (const WadLump& lump : *lumps) {
    SCOPED_TRACE(lump.name);
    const base::ByteVector data(lump.data.begin(), lump.data.end());
    if (base::to_lower(lump.name) == "conchars") {
      EXPECT_TRUE(read_conchars(data).ok());
    } else if (lump.type == kWadPicture) {
      const auto picture = read_picture(data);
      ASSERT_TRUE(picture.ok()) << picture.error().message();
      EXPECT_EQ(write_picture(*picture), data);
    } else {
      ASSERT_EQ(lump.type, kWadTexture);
      const auto texture = read_wad_texture(data);
      ASSERT_TRUE(texture.ok()) << texture.error().message();
      const auto written = write_wad_texture(*texture);
      ASSERT_TRUE(written.ok());
      const auto read_again = read_wad_texture(*written);
      ASSERT_TRUE(read_again.ok());
      EXPECT_EQ(*read_again, *texture);
    }
  }
}

TEST(Wad, ReadsStockFiles) {
  DATA_FOLDER_OR_SKIP(data);
  check_stock_wad(data / "id1" / "gfx.wad");
  if (!std::filesystem::is_directory(data / "wads")) return;
  for (const auto& entry : std::filesystem::directory_iterator(data / "wads"))
    if (entry.path().extension() == ".wad") check_stock_wad(entry.path());
}

}  // namespace
}  // namespace temblor::formats
