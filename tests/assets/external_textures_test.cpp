#include "assets/level/external_textures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "artgen/small_level.h"
#include "assets/assets.h"
#include "formats/archives/pk3.h"
#include "formats/images/png.h"
#include "support/programs/temporary_folder.h"

namespace temblor::assets {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

formats::Image solid(std::uint32_t color, std::uint32_t side = 16) {
  return {side, side, std::vector<std::uint32_t>(std::size_t{side} * side, color)};
}
base::ByteVector png(std::uint32_t color, std::uint32_t side = 16) {
  return formats::write_png(solid(color, side)).value();
}
base::ByteVector tga(std::uint32_t color, std::uint32_t side = 16) {
  return formats::write_tga(solid(color, side));
}

constexpr std::uint32_t kRed = 0xff902010, kGreen = 0xff207030, kBlue = 0xff303090;

// Game folders with a level of two textures, "Wall" and "*slime", of 16 x 16 texels.
class ExternalTextures : public testing::Test {
 protected:
  ExternalTextures() {
    bsp_ = artgen::make_small_level({.tiny = true});
    bsp_.miptexes.resize(2, bsp_.miptexes[0]);
    bsp_.miptexes[1] = bsp_.miptexes[0];
    bsp_.miptexes[0].name = "Wall";
    bsp_.miptexes[1].name = "*slime";
    for (formats::BspTexinfo& texinfo : bsp_.texinfos) texinfo.miptex = 0;
    write("id1/maps/tiny.bsp", formats::write_bsp(bsp_, formats::BspVersion::k29).value());
    write("id1/gfx/palette.lmp", formats::write_palette(artgen::make_palette()));
  }

  void write(std::string_view name, const base::ByteVector& bytes) { folder_.write(name, bytes); }

  LoadedLevel load(const std::vector<std::string>& games = {}, bool external_textures = true) {
    const vfs::FileSystem files = vfs::FileSystem::open(folder_.path(), games).value();
    return load_level(files, "tiny", {.external_textures = external_textures}).value();
  }
  // The first texel that 32-bit frames show; 0: the level's own texture.
  static std::uint32_t first_color(const LoadedLevel& loaded, std::size_t texture = 0) {
    const world::Texture& wall = loaded.level->textures[texture];
    return wall.colors ? wall.colors->colors[0][0] : 0;
  }

  formats::Bsp bsp_;
  const test::TemporaryFolder folder_;
};

TEST_F(ExternalTextures, AreFoundInTheirOrder) {
  EXPECT_EQ(first_color(load()), 0u);
  write("id1/textures/wall.png", png(kRed));
  EXPECT_EQ(first_color(load()), kRed);
  EXPECT_EQ(first_color(load({}, false)), 0u) << "switched off";
  write("id1/textures/wall.tga", tga(kGreen));
  EXPECT_EQ(first_color(load()), kGreen) << "TGA before PNG";
  write("mod/textures/wall.png", png(kBlue));
  EXPECT_EQ(first_color(load({"mod"})), kBlue) << "the mod's";
  write("id1/textures/tiny/wall.png", png(kRed));
  EXPECT_EQ(first_color(load()), kRed) << "this level's";
  write("id1/textures/#slime.tga", tga(kBlue));
  EXPECT_EQ(first_color(load(), 1), kBlue);
  EXPECT_THAT(load().notes, IsEmpty());
}

// id1's pictures for its level "tiny" do not fit the mod's level of the same name.
TEST_F(ExternalTextures, OfAHiddenLevelAreNotUsed) {
  write("id1/textures/tiny/wall.png", png(kRed));
  write("id1/textures/wall.png", png(kGreen));
  write("mod/maps/tiny.bsp", formats::write_bsp(bsp_, formats::BspVersion::k29).value());
  EXPECT_EQ(first_color(load({"mod"})), kGreen);
}

TEST_F(ExternalTextures, AreReadFromArchives) {
  const base::ByteVector picture = png(kBlue);
  write("id1/pack.pk3",
        formats::write_pk3(std::vector<formats::ArchiveFile>{{"textures/WALL.png", picture}}).value());
  EXPECT_EQ(first_color(load()), kBlue);
}

TEST_F(ExternalTextures, GlowIfAPictureOfTheGlowIsNextToThem) {
  write("id1/textures/wall.png", png(kRed));
  EXPECT_THAT(load().level->textures[0].colors->glow, IsEmpty());
  write("id1/textures/wall_luma.png", png(kGreen));
  EXPECT_EQ(load().level->textures[0].colors->glow[0][0], kGreen & 0xffffffu);
  write("id1/textures/wall_glow.tga", tga(kBlue));
  EXPECT_EQ(load().level->textures[0].colors->glow[0][0], kBlue & 0xffffffu);
  write("id1/textures/wall_glow.tga", base::ByteVector(5));
  const LoadedLevel damaged = load();
  EXPECT_EQ(first_color(damaged), kRed);
  EXPECT_THAT(damaged.notes, ElementsAre(AllOf(HasSubstr("wall_glow.tga"), HasSubstr("does not glow"))));
}

// A picture in exactly the palette's colors gives exactly the level's own texels.
TEST_F(ExternalTextures, InThePalettesColorsAreTheLevelsOwn) {
  const formats::Palette palette = artgen::make_palette();
  const std::vector<std::uint8_t>& own = bsp_.miptexes[0].mips[0];
  formats::Image picture{bsp_.miptexes[0].width, bsp_.miptexes[0].height, {}};
  for (const std::uint8_t index : own) {
    const formats::Rgb color = palette[index];
    picture.pixels.push_back(0xff000000u | std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 |
                             color.b);
  }
  write("id1/textures/wall.png", formats::write_png(picture).value());
  const LoadedLevel loaded = load();
  const world::Texture& wall = loaded.level->textures[0];
  ASSERT_EQ(wall.mips[0].size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) ASSERT_EQ(palette[wall.mips[0][i]], palette[own[i]]) << i;
  EXPECT_EQ(wall.colors->colors[0], picture.pixels);
}

TEST_F(ExternalTextures, OfAnySizeFitTheTexture) {
  for (const std::uint32_t side : {1u, 7u, 16u, 64u, 100u, 500u}) {
    write("id1/textures/wall.tga", tga(kGreen, side));
    const LoadedLevel loaded = load();
    const world::Texture& wall = loaded.level->textures[0];
    EXPECT_EQ(wall.width, 16u);
    EXPECT_EQ(wall.finest_mip(), side <= 16 ? 0 : side <= 64 ? -2 : -3) << side;
    for (const auto& level : wall.colors->colors)
      for (const std::uint32_t color : level) ASSERT_EQ(color, kGreen);
  }
}

TEST_F(ExternalTextures, ThatAreDamagedOrTooLargeAreNamed) {
  const base::ByteVector good = png(kRed, 64);
  write("id1/textures/wall.png", base::ByteVector(good.begin(), good.begin() + 50));
  const LoadedLevel damaged = load();
  EXPECT_EQ(first_color(damaged), 0u);
  EXPECT_THAT(damaged.notes,
              ElementsAre(AllOf(HasSubstr("textures/wall.png"), HasSubstr("own texture is drawn"))));
  write("id1/textures/wall.png", png(kRed, 4097));
  const LoadedLevel large = load();
  EXPECT_EQ(first_color(large), 0u);
  EXPECT_THAT(large.notes, ElementsAre(AllOf(HasSubstr("textures/wall.png"), HasSubstr("4097 x 4097"))));
}

}  // namespace
}  // namespace temblor::assets
