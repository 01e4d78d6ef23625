// Textures that a level of Half-Life takes from WADs.
#include "assets/level/wad_textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "artgen/small_level.h"
#include "assets/assets.h"
#include "formats/archives/wad.h"
#include "formats/images/wad3_texture.h"
#include "support/programs/temporary_folder.h"

namespace temblor::assets {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

formats::Wad3Texture make_texture(std::string name, std::uint32_t side, std::uint8_t index) {
  formats::Wad3Texture texture;
  texture.texture.name = std::move(name);
  texture.texture.width = texture.texture.height = side;
  for (std::uint32_t mip = 0; mip < 4; ++mip)
    texture.texture.mips[mip].assign(std::size_t{side >> mip} * (side >> mip), index);
  texture.palette[index] = {10, 20, 30};
  return texture;
}

// A WAD with one texture, as Half-Life's tools write it.
base::ByteVector make_wad3(const formats::Wad3Texture& texture) {
  const base::ByteVector lump = formats::write_wad3_texture(texture).value();
  base::ByteVector wad =
      formats::write_wad(std::vector<formats::WadLump>{{texture.texture.name, formats::kWad3Texture, lump}})
          .value();
  wad[3] = std::byte{'3'};
  return wad;
}

// The small level in version 30, with the texels of its first texture elsewhere.
formats::Bsp make_level_without_texels(std::string_view wad_key) {
  formats::Bsp bsp = artgen::make_small_level({.tiny = true});
  bsp.version = formats::BspVersion::k30;
  const std::size_t place = bsp.entities.find("\"worldspawn\"");
  bsp.entities.insert(place + 12, fmt::format("\n\"wad\" \"{}\"", wad_key));
  bsp.miptexes[0].name = "crate";
  bsp.miptexes[0].mips = {};
  return bsp;
}

TEST(WadTextures, ListsFileNamesOnly) {
  const auto list = [](std::string_view key) {
    return list_wads(fmt::format("{{\"classname\" \"worldspawn\" \"wad\" \"{}\"}}", key));
  };
  EXPECT_THAT(list("\\\\sierra\\half-life\\valve\\HalfLife.WAD;C:\\a/b\\liquids.wad;liquids.wad"),
              ElementsAre("halflife.wad", "liquids.wad"));
  EXPECT_THAT(list("../../etc/passwd;../x.wad;c:y.wad;;notes.txt"), ElementsAre("x.wad", "y.wad"));
  EXPECT_THAT(list(""), IsEmpty());
  EXPECT_THAT(list_wads("no entities"), IsEmpty());
}

TEST(WadTextures, FirstWadThatHasTheNameCounts) {
  const std::map<std::string, base::ByteVector, std::less<>> wads = {
      {"a.wad", make_wad3(make_texture("other", 16, 1))},
      {"b.wad", make_wad3(make_texture("CRATE", 32, 2))},
      {"c.wad", make_wad3(make_texture("crate", 64, 3))}};
  const auto read = [&](std::string_view name) -> std::optional<Addition> {
    const auto found = wads.find(name);
    if (found == wads.end()) return std::nullopt;
    return Addition{std::string(name), found->second};
  };
  formats::Bsp bsp = make_level_without_texels("a.wad;b.wad;c.wad");
  std::vector<std::string> notes;
  fill_wad_textures(read, bsp, notes);
  EXPECT_THAT(notes, IsEmpty());
  EXPECT_EQ(bsp.miptexes[0].name, "crate");
  EXPECT_EQ(bsp.miptexes[0].width, 32u);
  EXPECT_EQ(bsp.miptexes[0].mips, make_texture("", 32, 2).texture.mips);
  ASSERT_EQ(bsp.miptexes[0].palette.size(), 256u);
  EXPECT_EQ(bsp.miptexes[0].palette[2], (formats::Rgb{10, 20, 30}));

  bsp = make_level_without_texels("missing.wad");
  fill_wad_textures(read, bsp, notes);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("missing.wad")));
  EXPECT_TRUE(bsp.miptexes[0].mips[0].empty());
}

TEST(WadTextures, DamagedWadsAreNoted) {
  const base::ByteVector whole = make_wad3(make_texture("crate", 16, 2));
  // The palette follows the texels, so the texture is damaged if its lump ends before.
  base::ByteVector short_lump = whole;
  const std::uint32_t table = static_cast<std::uint32_t>(whole.size() - 32);
  for (const std::size_t field : {4u, 8u}) short_lump[table + field] = std::byte{60};
  for (const std::size_t field : {5u, 9u}) short_lump[table + field] = std::byte{0};
  for (const base::ByteVector& wad : {base::ByteVector(), base::ByteVector(20), short_lump}) {
    formats::Bsp bsp = make_level_without_texels("x.wad");
    std::vector<std::string> notes;
    fill_wad_textures([&](std::string_view) { return std::optional(Addition{"x.wad", wad}); }, bsp, notes);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("x.wad")));
    EXPECT_TRUE(bsp.miptexes[0].mips[0].empty());
  }
}

TEST(WadTextures, LevelsOfQuakeKeepTheirCheckerboard) {
  formats::Bsp bsp = make_level_without_texels("x.wad");
  bsp.version = formats::BspVersion::k29;
  std::vector<std::string> notes;
  const auto read = [](std::string_view) -> std::optional<Addition> {
    ADD_FAILURE() << "no WAD is needed";
    return std::nullopt;
  };
  fill_wad_textures(read, bsp, notes);
  EXPECT_THAT(notes, IsEmpty());
}

TEST(WadTextures, AreFoundInTheGameFolderAndItsWadFolders) {
  const base::ByteVector wad = make_wad3(make_texture("crate", 16, 2));
  const formats::Bsp bsp = make_level_without_texels("\\\\x\\Things.wad");
  for (const char* place : {"things.wad", "wads/things.wad", "textures/wads/things.wad", "maps/things.wad"}) {
    const test::TemporaryFolder folder;
    const auto path =
        folder.write("id1/maps/tiny.bsp", formats::write_bsp(bsp, formats::BspVersion::k30).value());
    folder.write(std::string("id1/") + place, wad);
    const auto files = vfs::FileSystem::open(folder.path(), {}).value();
    for (const auto& loaded : {load_level(files, "tiny"), load_level_file(path)}) {
      ASSERT_TRUE(loaded.ok()) << loaded.error().message();
      EXPECT_FALSE(loaded->level->textures[0].missing) << place;
      EXPECT_EQ(loaded->level->textures[0].width, 16u);
      EXPECT_THAT(loaded->notes, ::testing::Not(Contains(HasSubstr("wad")))) << place;
    }
  }
}

// Textures with a palette of their own keep their colors, and get the game's nearest ones, never full-bright
// ones.
TEST(WadTextures, OwnPalettesKeepTheirColors) {
  formats::Palette game;
  game.fill({11, 21, 31});   // near the texture's color
  game[240] = {10, 20, 30};  // the same color, but full-bright
  const test::TemporaryFolder folder;
  folder.write("id1/maps/tiny.bsp",
               formats::write_bsp(make_level_without_texels("x.wad"), formats::BspVersion::k30).value());
  folder.write("id1/x.wad", make_wad3(make_texture("crate", 16, 2)));
  folder.write("id1/gfx/palette.lmp", formats::write_palette(game));
  const auto loaded = load_level(vfs::FileSystem::open(folder.path(), {}).value(), "tiny");
  ASSERT_TRUE(loaded.ok()) << loaded.error().message();
  const world::Texture& texture = loaded->level->textures[0];
  for (const auto& mip : texture.mips) EXPECT_THAT(mip, Each(::testing::Lt(224)));
  ASSERT_NE(texture.colors, nullptr);
  for (const auto& level : texture.colors->colors) EXPECT_THAT(level, Each(0xff0a141eu));
}

}  // namespace
}  // namespace temblor::assets
