#include "compiler/texture_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "artgen/small_level.h"
#include "formats/archives/wad.h"
#include "formats/images/wad3_texture.h"
#include "formats/levels/map.h"
#include "support/game_data.h"

namespace temblor::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

formats::WadTexture plain_texture(const std::string& name, std::uint8_t index, std::uint32_t side = 16) {
  formats::WadTexture texture{name, side, side, {}};
  for (unsigned k = 0; k < 4; ++k)
    texture.mips[k].assign(std::size_t{side >> k} * (side >> k), static_cast<std::uint8_t>(index + k));
  return texture;
}

// A WAD2 with a texture of a single index (one more in each smaller mip level) for each name.
base::ByteVector make_wad2(const std::vector<std::pair<std::string, std::uint8_t>>& names_and_indices) {
  std::vector<base::ByteVector> contents;
  for (const auto& [name, index] : names_and_indices)
    contents.push_back(formats::write_wad_texture(plain_texture(name, index)).value());
  std::vector<formats::WadLump> lumps;
  for (std::size_t i = 0; i < contents.size(); ++i)
    lumps.push_back({names_and_indices[i].first, formats::kWadTexture, contents[i]});
  return formats::write_wad(lumps).value();
}

struct Made {
  TextureSet set;
  Warnings warnings;

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const formats::BspMiptex& miptex : set.miptexes) names.push_back(miptex.name);
    return names;
  }
  const formats::BspMiptex& at(std::string_view name) const {
    return set.miptexes.at(set.find(name).value());
  }
};

Made make(const std::vector<std::string_view>& names, const std::vector<TextureSource>& sources,
          MipLevels mip_levels = MipLevels::kFromSource) {
  Made made;
  made.set = make_texture_set(names, sources, artgen::make_palette(), mip_levels, made.warnings);
  return made;
}

auto warning(const char* kind, const char* what) {
  return AllOf(Field(&Warning::kind, kind), Field(&Warning::what, HasSubstr(what)));
}

TEST(TextureSet, FindsEachNameOnceInTheFirstSource) {
  const base::ByteVector first = make_wad2({{"Wall", 1}, {"floor", 2}});
  const base::ByteVector second = make_wad2({{"WALL", 3}, {"*Water", 4}});
  const Made made = make({"wall", "*water", "WALL", "Floor"}, {{"a.wad", first}, {"b.wad", second}});
  EXPECT_THAT(made.warnings, IsEmpty());
  EXPECT_THAT(made.names(), ElementsAre("Wall", "*Water", "floor"));
  EXPECT_EQ(made.set.find("wAlL"), 0u);
  EXPECT_EQ(made.set.find("sky"), std::nullopt);
  const formats::BspMiptex& wall = made.at("wall");
  EXPECT_TRUE(wall.present);
  EXPECT_EQ(wall.width, 16u);
  EXPECT_EQ(wall.mips[0], std::vector<std::uint8_t>(256, 1));
  EXPECT_EQ(wall.mips[3], std::vector<std::uint8_t>(4, 4));  // the WAD's own
}

TEST(TextureSet, BuiltMipLevelsComeFromTheLargest) {
  const base::ByteVector wad = make_wad2({{"wall", 20}});
  EXPECT_EQ(make({"wall"}, {{"a.wad", wad}}, MipLevels::kBuilt).at("wall").mips[3],
            std::vector<std::uint8_t>(4, 20));
}

TEST(TextureSet, IncludesWholeAnimations) {
  const base::ByteVector wad =
      make_wad2({{"+2slip", 3}, {"+0slip", 1}, {"+1slip", 2}, {"+Aslip", 4}, {"+x", 5}});
  const Made made = make({"+1slip", "+x"}, {{"a.wad", wad}});
  EXPECT_THAT(made.names(), ElementsAre("+1slip", "+x", "+0slip", "+2slip", "+Aslip"));
  EXPECT_THAT(made.warnings, IsEmpty());
}

TEST(TextureSet, FramesMayComeFromSeveralSources) {
  const base::ByteVector first = make_wad2({{"+0slip", 1}}), second = make_wad2({{"+1slip", 2}});
  EXPECT_THAT(make({"+0slip"}, {{"a.wad", first}, {"b.wad", second}}).names(),
              ElementsAre("+0slip", "+1slip"));
}

TEST(TextureSet, CutsLongNamesOfFrames) {
  const base::ByteVector wad = make_wad2({{"+0cdefghijklmnop", 1}, {"+1cdefghijklmnop", 2}});
  const Made made = make({"+0cdefghijklmnop"}, {{"a.wad", wad}});
  EXPECT_THAT(made.warnings, IsEmpty());
  EXPECT_THAT(made.names(), ElementsAre("+0cdefghijklmno", "+1cdefghijklmno"));
}

TEST(TextureSet, WarnsAboutGapsInAnimations) {
  const base::ByteVector wad = make_wad2({{"+0slip", 1}, {"+2slip", 2}, {"+bslip", 2}});
  EXPECT_THAT(
      make({"+0slip", "+2slip"}, {{"a.wad", wad}}).warnings,
      ElementsAre(warning("animation has gaps", "\"+1slip\""), warning("animation has gaps", "\"+aslip\"")));
}

TEST(TextureSet, MissingTexturesAreCheckerboards) {
  const Made made = make({"wall", std::string(500, 'n'), ""}, {});
  EXPECT_THAT(made.set.missing, ElementsAre("wall", std::string(500, 'n'), ""));
  EXPECT_THAT(made.warnings, IsEmpty());
  const formats::BspMiptex& wall = made.at("wall");
  EXPECT_EQ(wall.name, "wall");
  EXPECT_EQ(wall.width, 64u);
  ASSERT_EQ(wall.mips[0].size(), 64u * 64u);
  EXPECT_NE(wall.mips[0][0], wall.mips[0][8]);
  EXPECT_NE(wall.mips[0][0], wall.mips[0][8 * 64]);
  EXPECT_EQ(wall.mips[3].size(), 64u);
  EXPECT_EQ(made.set.miptexes[1].name, std::string(15, 'n'));
}

TEST(TextureSet, CutsNamesAtFifteenCharacters) {
  const base::ByteVector wad = make_wad2({{"abcdefghijklmnop", 1}});
  const Made one = make({"ABCDEFGHIJKLMNOP", "abcdefghijklmnop"}, {{"a.wad", wad}});
  EXPECT_THAT(one.names(), ElementsAre("abcdefghijklmno"));
  EXPECT_THAT(one.warnings, IsEmpty());
  EXPECT_EQ(one.set.find("abcdefghijklmnop"), 0u);
  const Made two = make({"abcdefghijklmnop", "abcdefghijklmnoq", "abcdefghijklmnoq"}, {{"a.wad", wad}});
  EXPECT_THAT(two.names(), ElementsAre("abcdefghijklmno"));
  EXPECT_THAT(two.warnings, ElementsAre(warning("texture names too long", "\"abcdefghijklmnoq\"")));
}

TEST(TextureSet, SkipsUnreadableSources) {
  const base::ByteVector sound = make_wad2({{"wall", 1}});
  const auto broken = formats::write_wad(
      std::vector<formats::WadLump>{{"floor", formats::kWadTexture, base::as_bytes("no texture")}});
  const Made made = make({"wall", "floor"}, {{"cut.wad", base::Bytes(sound).first(20)},
                                             {"text.bsp", base::as_bytes("nonsense")},
                                             {"broken.wad", *broken},
                                             {"a.wad", sound}});
  EXPECT_THAT(made.warnings, ElementsAre(warning("texture source cannot be read", "cut.wad: "),
                                         warning("texture source cannot be read", "text.bsp: "),
                                         warning("texture cannot be read", "broken.wad: \"floor\": ")));
  EXPECT_EQ(made.at("wall").width, 16u);
  EXPECT_EQ(made.at("floor").width, 64u);
}

TEST(TextureSet, WarnsAboutOddSides) {
  const base::ByteVector texture = formats::write_wad_texture(plain_texture("wall", 1, 24)).value();
  const auto wad = formats::write_wad(std::vector<formats::WadLump>{{"wall", formats::kWadTexture, texture}});
  EXPECT_THAT(make({"wall"}, {{"a.wad", *wad}}).warnings,
              ElementsAre(warning("texture size", "\"wall\" has 24 x 24 texels")));
}

TEST(TextureSet, ConvertsWad3TexturesToThePalette) {
  formats::Wad3Texture texture;
  texture.texture = plain_texture("{crate", 252);  // mip level 3 has index 255
  const formats::Palette game = artgen::make_palette();
  texture.palette[252] = game[33];
  const base::ByteVector bytes = formats::write_wad3_texture(texture).value();
  base::ByteVector wad =
      formats::write_wad(std::vector<formats::WadLump>{{"{crate", formats::kWad3Texture, bytes}}).value();
  wad[3] = std::byte{'3'};
  const Made made = make({"{crate"}, {{"a.wad", wad}});
  EXPECT_EQ(game[made.at("{crate").mips[0][0]], game[33]);
  EXPECT_EQ(made.at("{crate").mips[3][0], 255);
}

TEST(TextureSet, LevelsAreSources) {
  formats::Bsp level = artgen::make_small_level();
  ASSERT_FALSE(level.miptexes.empty());
  const base::ByteVector bytes = formats::write_bsp(level, formats::BspVersion::k29).value();
  const Made made = make({level.miptexes[0].name}, {{"small.bsp", bytes}});
  EXPECT_THAT(made.warnings, IsEmpty());
  EXPECT_EQ(made.set.miptexes, std::vector{level.miptexes[0]});
}

std::vector<base::ByteVector> read_stock_wads(const std::filesystem::path& data) {
  std::vector<base::ByteVector> files;
  for (const auto& entry : std::filesystem::directory_iterator(data / "wads"))
    files.push_back(test::read_file(entry.path()));
  return files;
}

TEST(TextureSet, FindsAllTexturesOfStockMaps) {
  DATA_FOLDER_OR_SKIP(data);
  const std::vector<base::ByteVector> files = read_stock_wads(data);
  std::vector<TextureSource> sources;
  for (const base::ByteVector& file : files) sources.push_back({"stock.wad", file});
  for (const auto& entry : std::filesystem::directory_iterator(data / "mapsrc")) {
    SCOPED_TRACE(entry.path().filename());
    const auto map = formats::read_map(base::as_text(test::read_file(entry.path()))).value();
    std::vector<std::string_view> names;
    for (const formats::MapEntity& entity : map.entities)
      for (const formats::MapBrush& brush : entity.brushes)
        for (const formats::MapSide& side : brush.sides) names.push_back(side.texture);
    const Made made = make(names, sources);
    EXPECT_GT(made.set.miptexes.size(), 1u);
    for (const std::string_view name : names) ASSERT_TRUE(made.set.find(name));
    for (const Warning& warning : made.warnings) ADD_FAILURE() << warning.kind << ": " << warning.what;
  }
}

// The finished levels were made from an earlier edition of the WADs: names and sizes are the same, and most
// texels are.
TEST(TextureSet, StockWadsHaveTheTexturesOfAFinishedLevel) {
  DATA_FOLDER_OR_SKIP(data);
  const std::vector<base::ByteVector> files = read_stock_wads(data);
  std::vector<TextureSource> sources;
  for (const base::ByteVector& file : files) sources.push_back({"stock.wad", file});
  const auto bsp = formats::read_bsp(test::read_file(data / "id1" / "maps" / "lq_e1m2.bsp")).value();
  std::vector<std::string_view> names;
  for (const formats::BspMiptex& miptex : bsp.miptexes)
    if (miptex.present) names.push_back(miptex.name);
  const Made made = make(names, sources);
  EXPECT_THAT(made.warnings, IsEmpty());
  EXPECT_EQ(made.set.miptexes.size(), names.size());  // the level's animations are complete
  std::size_t equal = 0;
  for (const formats::BspMiptex& miptex : bsp.miptexes) {
    if (!miptex.present) continue;
    const formats::BspMiptex& ours = made.at(miptex.name);
    EXPECT_EQ(std::pair(ours.width, ours.height), std::pair(miptex.width, miptex.height)) << miptex.name;
    equal += ours.mips == miptex.mips;
  }
  EXPECT_GT(names.size(), 50u);
  EXPECT_GT(2 * equal, names.size());
}

}  // namespace
}  // namespace temblor::compiler
