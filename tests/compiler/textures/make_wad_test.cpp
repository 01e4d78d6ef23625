#include "compiler/make_wad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "compiler/textures/texture_from_image.h"
#include "formats/archives/wad.h"
#include "formats/images/png.h"
#include "formats/images/wad_texture.h"
#include "support/random.h"

namespace temblor::compiler {
namespace {

using ::testing::HasSubstr;

const formats::Palette& palette() {
  static const formats::Palette palette = artgen::make_palette();
  return palette;
}

std::uint32_t argb(formats::Rgb color, std::uint32_t alpha = 255) {
  return (alpha << 24) | (std::uint32_t{color.r} << 16) | (std::uint32_t{color.g} << 8) | color.b;
}

base::ByteVector make_png(const std::vector<std::uint8_t>& indices, int width, int height) {
  return formats::write_png(indices, width, height, palette()).value();
}

base::ByteVector plain_png(std::uint8_t index, int width = 16, int height = 16) {
  return make_png(std::vector<std::uint8_t>(static_cast<std::size_t>(width * height), index), width, height);
}

std::string error_text(const std::vector<PngFile>& files) {
  const auto wad = make_wad(files, palette());
  return wad.ok() ? "no error" : wad.error().message();
}

TEST(MakeWad, NamesComeFromFiles) {
  EXPECT_EQ(texture_name_from_file("textures/Wall_1.png"), "Wall_1");
  EXPECT_EQ(texture_name_from_file("#water1.png"), "*water1");
  EXPECT_EQ(texture_name_from_file("+0slip#.png"), "+0slip#");
}

TEST(MakeWad, PaletteColorsStayUnchanged) {
  test::Random random(1);
  std::vector<std::uint8_t> indices(32 * 16);
  for (std::uint8_t& index : indices) index = static_cast<std::uint8_t>(random.below(255));
  const base::ByteVector png = make_png(indices, 32, 16), other = plain_png(100);
  const auto wad = make_wad(std::vector<PngFile>{{"d/Wall.png", png}, {"d/#lava.png", other}}, palette());
  ASSERT_TRUE(wad.ok()) << wad.error().message();
  const auto lumps = formats::read_wad(*wad);
  ASSERT_EQ(lumps->size(), 2u);
  EXPECT_EQ(lumps->at(0).name, "Wall");
  EXPECT_EQ(lumps->at(1).name, "*lava");
  EXPECT_EQ(lumps->at(0).type, formats::kWadTexture);
  const auto wall = formats::read_wad_texture(lumps->at(0).data);
  ASSERT_TRUE(wall.ok());
  EXPECT_EQ(wall->name, "Wall");
  EXPECT_EQ(wall->width, 32u);
  EXPECT_EQ(wall->mips[3].size(), 8u);
  for (std::size_t i = 0; i < indices.size(); ++i)
    EXPECT_EQ(palette()[wall->mips[0][i]], palette()[indices[i]]) << i;
}

TEST(MakeWad, FullBrightOnlyForExactColors) {
  // A full-bright color and one next to it, both far from all other colors of the palette.
  formats::Palette made{};
  made[224] = {250, 120, 10};
  const formats::MipColors colors(made);
  formats::Image image{16, 16, std::vector<std::uint32_t>(256, argb({250, 120, 10}))};
  image.pixels[1] = argb({250, 121, 10});
  const auto texture = texture_from_image("lamp", image, colors);
  ASSERT_TRUE(texture.ok());
  EXPECT_EQ(texture->mips[0][0], 224);
  EXPECT_LT(texture->mips[0][1], 224);
}

TEST(MakeWad, HolesWhereTheImageIsTransparent) {
  const formats::MipColors colors(palette());
  formats::Image image{16, 16, std::vector<std::uint32_t>(256, argb(palette()[40]))};
  image.pixels[0] = argb(palette()[40], 127);
  image.pixels[1] = argb(palette()[40], 128);
  image.pixels[2] = argb(palette()[255]);
  const auto fence = texture_from_image("{fence", image, colors);
  EXPECT_EQ(fence->mips[0][0], 255);
  EXPECT_EQ(palette()[fence->mips[0][1]], palette()[40]);
  EXPECT_NE(fence->mips[0][2], 255);
  EXPECT_NE(texture_from_image("wall", image, colors)->mips[0][0], 255);
}

TEST(MakeWad, ErrorsNameTheFile) {
  const base::ByteVector png = plain_png(1), odd = plain_png(1, 24, 16);
  EXPECT_EQ(error_text({{"a/odd.png", odd}}),
            "a/odd.png: 24 x 16 pixels: width and height must be multiples of 16");
  EXPECT_THAT(error_text({{"a/text.png", base::as_bytes("no picture")}}), HasSubstr("a/text.png: "));
  EXPECT_EQ(error_text({{"wall.png", png}, {"b/Wall.png", png}}),
            "b/Wall.png: has the same texture name as wall.png");
  EXPECT_EQ(error_text({{"sixteen_letters_.png", png}}),
            "sixteen_letters_.png: \"sixteen_letters_\": texture names have 1 to 15 characters");
  EXPECT_EQ(error_text({{"fifteen_letters.png", png}}), "no error");
  EXPECT_EQ(error_text({}), "no error");
}

}  // namespace
}  // namespace temblor::compiler
