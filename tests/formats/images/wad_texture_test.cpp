#include "formats/images/wad_texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::size_t kWidthField = 16;
constexpr std::size_t kHeightField = 20;
constexpr std::size_t kMipField = 24;

// 16 x 8 texels; every texel of mip k is 10 + k. The mips are stored in reverse order.
base::ByteVector hand_made_texture() {
  base::ByteWriter writer;
  writer.fixed_text("*lava1", 16);
  writer.u32(16);
  writer.u32(8);
  const std::uint32_t sizes[] = {128, 32, 8, 2};
  std::uint32_t offset = 40 + 128 + 32 + 8 + 2;
  for (const std::uint32_t size : sizes) writer.u32(offset -= size);
  for (std::uint8_t level = 4; level-- > 0;)
    for (std::uint32_t i = 0; i < sizes[level]; ++i) writer.u8(static_cast<std::uint8_t>(10 + level));
  return std::move(writer).take();
}

TEST(WadTexture, ReadsHandMadeFile) {
  const auto texture = read_wad_texture(hand_made_texture());
  ASSERT_TRUE(texture.ok()) << texture.error().message();
  EXPECT_EQ(texture->name, "*lava1");
  EXPECT_EQ(texture->width, 16u);
  EXPECT_EQ(texture->height, 8u);
  EXPECT_EQ(texture->mips[0], std::vector<std::uint8_t>(128, 10));
  EXPECT_EQ(texture->mips[1], std::vector<std::uint8_t>(32, 11));
  EXPECT_EQ(texture->mips[2], std::vector<std::uint8_t>(8, 12));
  EXPECT_THAT(texture->mips[3], ElementsAre(13, 13));
}

TEST(WadTexture, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    WadTexture texture;
    texture.name = std::string(random.below(17), 't');
    texture.width =
        static_cast<std::uint32_t>(1 + random.below(40));  // includes sides that become 0 in a mip
    texture.height = static_cast<std::uint32_t>(1 + random.below(40));
    for (std::uint32_t k = 0; k < 4; ++k) {
      texture.mips[k].resize(std::size_t{texture.width >> k} * (texture.height >> k));
      for (std::uint8_t& texel : texture.mips[k]) texel = static_cast<std::uint8_t>(random.below(256));
    }
    const auto bytes = write_wad_texture(texture);
    ASSERT_TRUE(bytes.ok()) << "seed " << seed;
    const auto read = read_wad_texture(*bytes);
    ASSERT_TRUE(read.ok()) << "seed " << seed << ": " << read.error().message();
    EXPECT_EQ(*read, texture) << "seed " << seed;
  }
}

// The mips are stored in reverse order, so every truncation cuts mip 0.
TEST(WadTexture, RejectsEveryTruncation) {
  test::for_each_truncation(hand_made_texture(), [](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_wad_texture(bytes).ok()) << bytes.size() << " bytes";
  });
}

TEST(WadTexture, SamplesSmallerMipsThatAreOutside) {
  base::ByteVector bytes = hand_made_texture();
  const auto mip0 = bytes.end() - 128;
  for (int i = 0; i < 128; ++i) mip0[i] = static_cast<std::byte>(i);
  for (const std::uint32_t offset : {0u, 39u, 209u, 0x7fffffffu, 0xffffffffu}) {
    const auto texture = read_wad_texture(test::with_number(bytes, kMipField + 4 * 2, offset));
    ASSERT_TRUE(texture.ok()) << texture.error().message();
    EXPECT_EQ(texture->mips[1], std::vector<std::uint8_t>(32, 11));
    EXPECT_THAT(texture->mips[2], ElementsAre(0, 4, 8, 12, 64, 68, 72, 76));
    EXPECT_THAT(texture->mips[3], ElementsAre(13, 13));
  }
}

TEST(WadTexture, RejectsHostileSizesAndOffsets) {
  const base::ByteVector valid = hand_made_texture();
  for (const std::uint32_t side : {0u, kMaxTextureSide + 1, 1u << 20, 0x80000000u, 0xffffffffu}) {
    for (const std::size_t field : {kWidthField, kHeightField}) {
      const auto texture = read_wad_texture(test::with_number(valid, field, side));
      ASSERT_FALSE(texture.ok()) << side;
      EXPECT_THAT(texture.error().what, HasSubstr("\"*lava1\""));
    }
  }
  for (const std::uint32_t offset : {0u, 39u, 83u, 0x7fffffffu, 0xffffffffu}) {
    const auto texture = read_wad_texture(test::with_number(valid, kMipField, offset));
    ASSERT_FALSE(texture.ok()) << offset;
    EXPECT_THAT(texture.error().what, HasSubstr("\"*lava1\": mip 0 at offset"));
  }
}

TEST(WadTexture, WriteRejectsWhatDoesNotFit) {
  EXPECT_FALSE(write_wad_texture({"empty", 0, 16, {}}).ok());
  EXPECT_FALSE(write_wad_texture({"wide", kMaxTextureSide + 1, 1, {}}).ok());
  WadTexture texture{std::string(17, 'n'), 1, 1, {}};
  texture.mips[0] = {7};
  EXPECT_FALSE(write_wad_texture(texture).ok());
  texture.name.pop_back();
  EXPECT_TRUE(write_wad_texture(texture).ok());
}

}  // namespace
}  // namespace temblor::formats
