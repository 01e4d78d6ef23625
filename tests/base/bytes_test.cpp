#include "base/bytes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <variant>

namespace temblor::base {
namespace {

ByteVector pack_bytes(std::initializer_list<int> values) {
  ByteVector bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

TEST(ByteReader, NumbersAreLittleEndian) {
  const ByteVector bytes = pack_bytes({0x01, 0x02, 0xff, 0xff, 0xfe, 0xca, 0x78, 0x56, 0x34, 0x12,  //
                                       0xfe, 0xff, 0xff, 0xff, 0x00, 0x00, 0xc0, 0x3f});
  ByteReader reader(bytes);
  EXPECT_EQ(reader.u16(), 0x0201);
  EXPECT_EQ(reader.i16(), -1);
  EXPECT_EQ(reader.u16(), 0xcafe);
  EXPECT_EQ(reader.u32(), 0x12345678u);
  EXPECT_EQ(reader.i32(), -2);
  EXPECT_EQ(reader.f32(), 1.5f);
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(reader.remaining(), 0u);
}

TEST(ByteReader, ReadPastEndReturnsZeroAndFails) {
  const ByteVector bytes = pack_bytes({1, 2, 3});
  ByteReader reader(bytes);
  EXPECT_EQ(reader.u32(), 0u);
  EXPECT_FALSE(reader.ok());
  // Three bytes were left before; now none are.
  EXPECT_EQ(reader.u8(), 0);
  EXPECT_EQ(reader.remaining(), 0u);
  reader.seek(0);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.u8(), 0);
}

TEST(ByteReader, HugeCountsDoNotWrapAround) {
  const ByteVector bytes = pack_bytes({1, 2, 3, 4});
  ByteReader taking(bytes);
  taking.u8();
  EXPECT_TRUE(taking.take(std::numeric_limits<std::size_t>::max()).empty());
  EXPECT_FALSE(taking.ok());
  ByteReader seeking(bytes);
  seeking.seek(std::numeric_limits<std::size_t>::max());
  EXPECT_FALSE(seeking.ok());
  EXPECT_EQ(seeking.remaining(), 0u);
}

TEST(ByteReader, SeekReachesEveryOffsetUpToTheEnd) {
  const ByteVector bytes = pack_bytes({10, 11, 12});
  for (std::size_t offset = 0; offset < 3; ++offset) {
    ByteReader reader(bytes);
    reader.seek(offset);
    EXPECT_EQ(reader.u8(), 10 + offset);
  }
  ByteReader reader(bytes);
  reader.seek(3);
  EXPECT_TRUE(reader.ok());
  reader.seek(4);
  EXPECT_FALSE(reader.ok());
}

TEST(ByteReader, FixedTextEndsAtZeroOrWidth) {
  const ByteVector bytes = pack_bytes({'a', 'b', 0, 'x', 'c', 'd', 'e', 'f'});
  ByteReader reader(bytes);
  EXPECT_EQ(reader.fixed_text(4), "ab");
  EXPECT_EQ(reader.fixed_text(4), "cdef");
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(reader.fixed_text(1), "");
  EXPECT_FALSE(reader.ok());
}

TEST(ByteWriter, WritesLittleEndian) {
  ByteWriter writer;
  writer.u8(0xab);
  writer.align(4);
  writer.i32(-2);
  writer.i16(-1);
  writer.fixed_text("abc", 2);
  writer.fixed_text("d", 3);
  writer.align(1);
  writer.bytes(as_bytes("z"));
  writer.patch(4, std::int32_t{0x01020304});
  EXPECT_EQ(writer.view(), pack_bytes({0xab, 0, 0, 0, 4, 3, 2, 1, 0xff, 0xff, 'a', 'b', 'd', 0, 0, 'z'}));
}

using Number = std::variant<std::uint8_t, std::int16_t, std::uint32_t, float>;

Number random_number(std::mt19937_64& random) {
  const std::uint64_t bits = random();
  switch (bits % 4) {
    case 0:
      return static_cast<std::uint8_t>(bits >> 8);
    case 1:
      return static_cast<std::int16_t>(bits >> 8);
    case 2:
      return static_cast<std::uint32_t>(bits >> 8);
    default:
      return static_cast<float>(bits >> 8);
  }
}

TEST(ByteWriter, RoundTrips) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<Number> record;
    for (int i = 0; i < 100; ++i) record.push_back(random_number(random));
    ByteWriter writer;
    for (const Number& number : record) std::visit([&](auto value) { writer.write(value); }, number);
    const ByteVector bytes = std::move(writer).take();
    ByteReader reader(bytes);
    for (const Number& number : record) {
      const bool same =
          std::visit([&](auto value) { return reader.read<decltype(value)>() == value; }, number);
      ASSERT_TRUE(same) << "seed " << seed << " before offset " << reader.offset();
    }
    EXPECT_TRUE(reader.ok());
    EXPECT_EQ(reader.remaining(), 0u);
  }
}

TEST(Bytes, TextAndBytesShareMemory) {
  const std::string text("a\0b", 3);
  EXPECT_EQ(as_text(as_bytes(text)), text);
  EXPECT_EQ(as_u8(as_bytes(text))[2], 'b');
  EXPECT_EQ(static_cast<const void*>(as_bytes(text).data()), text.data());
}

}  // namespace
}  // namespace temblor::base
