// Compares textures with the meaning of their scripts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/art.h"
#include "artgen/palette.h"
#include "artgen/textures/letters.h"
#include "artgen/textures/texture.h"
#include "formats/archives/wad.h"
#include "formats/images/wad_texture.h"

namespace temblor::artgen {
namespace {

using testing::ElementsAre;

base::Result<std::vector<formats::WadTexture>> make(std::string_view script) {
  TRY(const std::vector<ScriptLine> lines, read_script(script));
  std::vector<formats::WadTexture> textures;
  for (const ScriptLine& line : lines) {
    const auto maker = line.keyword == "switch"      ? make_switch
                       : line.keyword == "animation" ? make_animation
                                                     : make_texture;
    TRY(const std::vector<ArtPart> parts, maker(line));
    for (const ArtPart& part : parts) {
      EXPECT_EQ(part.path, "textures.wad");
      EXPECT_EQ(part.lump_type, formats::kWadTexture);
      TRY(formats::WadTexture texture, formats::read_wad_texture(part.bytes));
      EXPECT_EQ(texture.name, part.lump);
      textures.push_back(std::move(texture));
    }
  }
  return textures;
}

formats::WadTexture one(std::string_view script) {
  base::Result<std::vector<formats::WadTexture>> made = make(script);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message());
  return made.ok() && !made->empty() ? made->front() : formats::WadTexture();
}

std::string texture_error(std::string_view script) {
  const base::Result<std::vector<formats::WadTexture>> made = make(script);
  return made.ok() ? "none" : made.error().message();
}

std::uint8_t texel(const formats::WadTexture& texture, std::uint32_t x, std::uint32_t y) {
  return texture.mips[0].at(std::size_t{y} * texture.width + x);
}

std::int64_t count_texels(const formats::WadTexture& texture, std::uint8_t index) {
  return std::count(texture.mips[0].begin(), texture.mips[0].end(), index);
}

const std::uint8_t kWall = ramp_color(Ramp::kSlate, 0.4);
const std::uint8_t kGold = ramp_color(Ramp::kGold, 0.6);

TEST(Textures, ShapesCoverTheirArea) {
  const formats::WadTexture box = one("texture a 32x16\n  fill slate 0.4\n  rect gold 0.6 at=4,2 size=10x6");
  EXPECT_EQ(count_texels(box, kGold), 60);
  EXPECT_EQ(count_texels(box, kWall), 32 * 16 - 60);
  EXPECT_EQ(texel(box, 4, 2), kGold);
  EXPECT_EQ(texel(box, 13, 7), kGold);
  EXPECT_EQ(texel(box, 14, 7), kWall);

  const formats::WadTexture round = one("texture a 32x32\n  fill slate 0.4\n  disc gold 0.6 radius=10");
  EXPECT_NEAR(static_cast<double>(count_texels(round, kGold)), 314, 12);
  const formats::WadTexture moss = one("texture a 64x64\n  fill slate 0.4\n  patches gold 0.6 cover=0.3");
  EXPECT_NEAR(static_cast<double>(count_texels(moss, kGold)) / (64 * 64), 0.3, 0.01);
  const formats::WadTexture bars =
      one("texture a 32x32\n  fill slate 0.4\n  stripes gold 0.6 every=8 width=3");
  EXPECT_EQ(count_texels(bars, kGold), 32 * 32 * 3 / 8);
}

TEST(Textures, ShapesWrapAround) {
  const formats::WadTexture box = one("texture a 16x16\n  fill slate 0.4\n  rect gold 0.6 at=12,12 size=8x8");
  EXPECT_EQ(count_texels(box, kGold), 64);
  EXPECT_EQ(texel(box, 0, 0), kGold);
  EXPECT_EQ(texel(box, 3, 3), kGold);
  EXPECT_EQ(texel(box, 4, 3), kWall);
}

TEST(Textures, LayersUnderAShapeShowOnlyInsideIt) {
  const formats::WadTexture made =
      one("texture a 32x32\n"
          "  fill slate 0.4\n"
          "  rect at=8,8 size=16x16\n"
          "    fill gold 0.6\n"
          "    inlay red 0.5 at=8,8 size=4x4\n");
  EXPECT_EQ(count_texels(made, kGold), 256 - 16);
  EXPECT_EQ(count_texels(made, ramp_color(Ramp::kRed, 0.5)), 16);
}

TEST(Textures, ReliefIsLitFromTheUpperLeft) {
  const formats::WadTexture made =
      one("texture a 32x32\n  fill slate 0.4\n  disc radius=10 raise=4 bevel=4\n  relief 1 cavity=0");
  EXPECT_GT(texel(made, 9, 9), kWall);
  EXPECT_LT(texel(made, 22, 22), kWall);
  EXPECT_EQ(texel(made, 0, 0), kWall);
  const formats::WadTexture hollow =
      one("texture a 32x32\n  fill slate 0.4\n  disc radius=10 raise=-4 bevel=4\n  relief 1 cavity=0");
  EXPECT_LT(texel(hollow, 9, 9), kWall);
  EXPECT_GT(texel(hollow, 22, 22), kWall);
}

TEST(Textures, LampsStayBrightAndLightTheirSurroundings) {
  const formats::WadTexture made =
      one("texture a 32x32\n  fill slate 0.4\n  disc fire 0.9 radius=6 raise=8\n  relief 1\n  halo radius=6 "
          "by=0.4");
  EXPECT_EQ(texel(made, 11, 16), ramp_color(Ramp::kFire, 0.9));
  EXPECT_EQ(texel(made, 20, 16), ramp_color(Ramp::kFire, 0.9));
  EXPECT_EQ(texel(one("texture a 32x32\n  fill slate 0.4\n  disc fire 0.9 radius=6\n  halo radius=6 by=0.4"),
                  8, 16) > kWall,
            true);
}

TEST(Textures, BricksHaveJointsBetweenCourses) {
  const formats::WadTexture made =
      one("texture a 32x32\n  fill slate 0.4\n  bricks width=16 height=8 joint=2 vary=0\n  joints gold 0.6");
  // Joints of two texels around each course and each brick; every second course is shifted by half a brick.
  EXPECT_EQ(count_texels(made, kGold), 4 * (2 * 32 + 6 * 2 * 2));
  EXPECT_EQ(texel(made, 0, 4), kGold);
  EXPECT_EQ(texel(made, 8, 4), kWall);
  EXPECT_EQ(texel(made, 8, 12), kGold);
}

TEST(Textures, LettersAreDrawnTexelByTexel) {
  EXPECT_EQ(measure_letters("AB"), 11);
  EXPECT_TRUE(has_ink("L", 0, 0));
  EXPECT_FALSE(has_ink("L", 1, 0));
  EXPECT_TRUE(has_ink("L", 4, 6));
  EXPECT_FALSE(has_ink("LL", 5, 6));
  EXPECT_TRUE(has_ink("LL", 6, 6));
  const formats::WadTexture sign = one("texture a 32x16\n  fill slate 0.4\n  text \"I\" gold 0.6 at=2,2");
  EXPECT_EQ(count_texels(sign, kGold), 3 + 5 + 3);
  EXPECT_EQ(
      count_texels(one("texture a 32x16\n  fill slate 0.4\n  text \"I\" gold 0.6 at=2,1 scale=2"), kGold),
      44);
}

TEST(Textures, AValueWithSlashesDiffersInEachFrame) {
  const base::Result<std::vector<formats::WadTexture>> frames = make(
      "animation glow 16x16 frames=3\n  fill slate 0.4/0.2/0.6\n  rect gold 0.6 at=0,0/4,0/8,0 size=2x2\n"
      "switch knob 16x16\n  fill slate 0.4/0.2\n");
  ASSERT_TRUE(frames.ok()) << frames.error().message();
  std::vector<std::string> names;
  for (const formats::WadTexture& frame : *frames) names.push_back(frame.name);
  EXPECT_THAT(names, ElementsAre("+0glow", "+1glow", "+2glow", "+0knob", "+aknob"));
  EXPECT_EQ(texel((*frames)[1], 15, 15), ramp_color(Ramp::kSlate, 0.2));
  EXPECT_EQ(texel((*frames)[1], 4, 0), kGold);
  EXPECT_EQ(texel((*frames)[2], 8, 0), kGold);
  EXPECT_EQ(texel((*frames)[4], 0, 0), ramp_color(Ramp::kSlate, 0.2));
}

TEST(Textures, FencesHaveHolesWhereNothingIsPainted) {
  const formats::WadTexture fence = one("texture {a 16x16\n  rect slate 0.4 at=0,0 size=16x4");
  EXPECT_EQ(count_texels(fence, kTransparent), 16 * 12);
  const formats::WadTexture cut =
      one("texture {a 16x16\n  fill slate 0.4\n  rect at=0,0 size=8x8 cut=yes\n  relief 1");
  EXPECT_EQ(count_texels(cut, kTransparent), 64);
}

TEST(Textures, AnAdditionalLineDoesNotChangeOthers) {
  const formats::WadTexture plain = one("texture a 64x64\n  fill slate 0.4\n  patches gold 0.6 cover=0.3");
  const formats::WadTexture more =
      one("texture a 64x64\n  fill slate 0.4\n  bumps by=1\n  patches gold 0.6 cover=0.3");
  EXPECT_EQ(plain, more);
  const formats::WadTexture seeded =
      one("texture a 64x64 seed=1\n  fill slate 0.4\n  patches gold 0.6 cover=0.3");
  EXPECT_NE(plain, seeded);
}

TEST(Textures, ErrorsNameTheLine) {
  EXPECT_EQ(texture_error("texture a 20x16"), "line 1: texture: 20x16: sides must be multiples of 16");
  EXPECT_EQ(texture_error("texture much_too_long_a_name 16x16"),
            "line 1: texture: 'much_too_long_a_name': a texture's name has 1 to 15 characters");
  EXPECT_EQ(texture_error("texture a 16x16\n  brcks"), "line 2: brcks: unknown texture layer");
  EXPECT_EQ(texture_error("texture a 16x16\n  fill slate 0.4\n    noise"),
            "line 3: noise: no line can be under this layer");
  EXPECT_EQ(texture_error("texture a 16x16\n  rect slat 0.4"),
            "line 2: rect: 'slat' is not a color ramp; expected one of gray brown brick sand red olive gold "
            "teal blue "
            "purple slate rust skin green fire electric");
  EXPECT_EQ(texture_error("texture a 16x16\n  rect at=4"), "line 2: rect: at=4 is not X,Y");
  EXPECT_EQ(texture_error("texture a 16x16\n  rect size=0x4"), "line 2: rect: size=0x4 is not WIDTHxHEIGHT");
  EXPECT_EQ(texture_error("texture a 16x16\n  disc\n    disc radios=4"),
            "line 3: disc: unknown setting 'radios'");
  EXPECT_EQ(texture_error("texture a 16x16\n  text \"~\""),
            "line 2: text: '~' cannot be written: signs have no such letter");
  EXPECT_EQ(texture_error("texture a 16x16\n  inlay size=32x8"),
            "line 2: inlay: size=32x8 is not inside 16x16");
  EXPECT_EQ(texture_error("animation a 16x16 frames=11"), "line 1: animation: frames=11 is not from 1 to 10");
}

}  // namespace
}  // namespace temblor::artgen
