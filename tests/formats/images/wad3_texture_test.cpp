#include "formats/images/wad3_texture.h"

#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kMipsEnd = 40 + 256 + 64 + 16 + 4;  // of a texture of 16 x 16

// Written field by field from the description of the format: 16 x 16 texels, all with index `index`, and a
// palette whose color i is (i, 255 - i, 7).
base::ByteVector hand_made_texture(std::string_view name, std::uint8_t index, std::uint16_t colors) {
  base::ByteWriter writer;
  writer.fixed_text(name, 16);
  writer.u32(16);
  writer.u32(16);
  for (const std::uint32_t offset : {40u, 40u + 256u, 40u + 320u, 40u + 336u}) writer.u32(offset);
  while (writer.size() < kMipsEnd) writer.u8(index);
  writer.u16(colors);
  for (int i = 0; i < colors; ++i) {
    writer.u8(static_cast<std::uint8_t>(i));
    writer.u8(static_cast<std::uint8_t>(255 - i));
    writer.u8(7);
  }
  return std::move(writer).take();
}

NearestColor dull(const Palette& game) {
  return NearestColor(game, 0, kFirstFullbright);
}

TEST(Wad3Texture, ReadsItsPalette) {
  const auto texture = read_wad3_texture(hand_made_texture("crate", 3, 200));
  ASSERT_TRUE(texture.ok()) << texture.error().message();
  EXPECT_EQ(texture->texture.name, "crate");
  EXPECT_EQ(texture->texture.mips[3], std::vector<std::uint8_t>(4, 3));
  EXPECT_EQ(texture->palette[199], (Rgb{199, 56, 7}));
  EXPECT_EQ(texture->palette[200], Rgb{});
}

TEST(Wad3Texture, WritesTheSameBytes) {
  const base::ByteVector bytes = hand_made_texture("crate", 255, 256);
  const auto written = write_wad3_texture(read_wad3_texture(bytes).value());
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(*written, bytes);
}

TEST(Wad3Texture, RejectsEveryTruncation) {
  test::for_each_truncation(hand_made_texture("crate", 3, 256), [](const base::ByteVector& bytes) {
    EXPECT_FALSE(read_wad3_texture(bytes).ok()) << bytes.size() << " bytes";
  });
  EXPECT_FALSE(read_wad3_texture(hand_made_texture("crate", 3, 257)).ok());
}

TEST(Wad3Texture, ConvertsToNearestDullColors) {
  const Palette game = artgen::make_palette();
  Wad3Texture texture = read_wad3_texture(hand_made_texture("crate", 255, 256)).value();
  // The color happens to be that of a fullbright entry.
  texture.palette[255] = game[240];
  EXPECT_LT(convert_to_palette(texture, game, dull(game)).mips[0][0], 224);
  texture.palette[255] = game[37];
  EXPECT_EQ(game[convert_to_palette(texture, game, dull(game)).mips[0][0]], game[37]);
}

TEST(Wad3Texture, KeepsFullbrightsOfGamePalette) {
  const Palette game = artgen::make_palette();
  Wad3Texture texture = read_wad3_texture(hand_made_texture("crate", 240, 256)).value();
  texture.palette = game;
  EXPECT_EQ(convert_to_palette(texture, game, dull(game)).mips[2][0], 240);
}

TEST(Wad3Texture, KeepsHoles) {
  const Palette game = artgen::make_palette();
  EXPECT_EQ(
      convert_to_palette(read_wad3_texture(hand_made_texture("{fence", 255, 256)).value(), game, dull(game))
          .mips[0][0],
      255);
  EXPECT_NE(
      convert_to_palette(read_wad3_texture(hand_made_texture("fence", 255, 256)).value(), game, dull(game))
          .mips[0][0],
      255);
}

}  // namespace
}  // namespace temblor::formats
