#include "assets/assets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artgen/small_level.h"
#include "formats/archives/pak.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "formats/levels/lit.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/vis_patch_bytes.h"
#include "support/mutations.h"
#include "support/programs/temporary_folder.h"

namespace temblor::assets {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

formats::Bsp tiny_level(bool missing_texture = false) {
  return artgen::make_small_level({.missing_texture = missing_texture, .tiny = true});
}

base::ByteVector pack_bytes(const formats::Bsp& bsp) {
  return formats::write_bsp(bsp, formats::BspVersion::k29).value();
}

// Colored light for the level: every sample is `value`, with `extra` samples too many.
base::ByteVector lit_for(const formats::Bsp& bsp, std::uint8_t value, std::size_t extra = 0) {
  return formats::write_lit({std::vector<std::uint8_t>(3 * (bsp.lighting.size() + extra), value)});
}

vfs::FileSystem open_or_die(const test::TemporaryFolder& base_folder,
                            const std::vector<std::string>& games = {}) {
  return vfs::FileSystem::open(base_folder.path(), games).value();
}

TEST(LoadLevel, FindsLevelAndLight) {
  const formats::Bsp bsp = tiny_level();
  const base::ByteVector bsp_bytes = pack_bytes(bsp);
  const base::ByteVector lit_bytes = lit_for(bsp, 77);
  const std::vector<formats::ArchiveFile> archived{{"maps/tiny.bsp", bsp_bytes},
                                                   {"maps/tiny.lit", lit_bytes}};
  const test::TemporaryFolder loose, pak, pk3;
  loose.write("id1/maps/tiny.bsp", bsp_bytes);
  loose.write("id1/maps/tiny.lit", lit_bytes);
  pak.write("id1/pak0.pak", formats::write_pak(archived).value());
  pk3.write("id1/tiny.pk3", formats::write_pk3(archived).value());
  for (const test::TemporaryFolder* folder : {&loose, &pak, &pk3}) {
    const auto loaded = load_level(open_or_die(*folder), "tiny");
    ASSERT_TRUE(loaded.ok()) << loaded.error().message();
    EXPECT_EQ(loaded->level->name, "tiny");
    EXPECT_EQ(loaded->level->faces.size(), bsp.faces.size());
    EXPECT_EQ(loaded->level->light, bsp.lighting);
    EXPECT_EQ(loaded->level->light_rgb, std::vector<std::uint8_t>(3 * bsp.lighting.size(), 77));
    EXPECT_THAT(loaded->notes, IsEmpty());
  }
}

TEST(LoadLevel, IgnoresMismatchedLightWithNote) {
  const formats::Bsp bsp = tiny_level();
  for (const base::ByteVector& lit :
       {lit_for(bsp, 1, 1), base::ByteVector{}, test::to_bytes("no light at all")}) {
    const test::TemporaryFolder folder;
    folder.write("id1/maps/tiny.bsp", pack_bytes(bsp));
    folder.write("id1/maps/tiny.lit", lit);
    const auto loaded = load_level(open_or_die(folder), "tiny");
    ASSERT_TRUE(loaded.ok()) << loaded.error().message();
    EXPECT_THAT(loaded->level->light_rgb, IsEmpty());
    EXPECT_THAT(loaded->notes, ElementsAre(AllOf(HasSubstr("tiny.lit"), HasSubstr("ignored"))));
  }
}

TEST(LoadLevel, IgnoresLightOfLowerGame) {
  const formats::Bsp bsp = tiny_level();
  const test::TemporaryFolder folder;
  folder.write("id1/maps/tiny.lit", lit_for(bsp, 1));
  folder.write("mod/maps/tiny.bsp", pack_bytes(bsp));
  folder.write("light/maps/tiny.lit", lit_for(bsp, 2));
  const auto without = load_level(open_or_die(folder, {"mod"}), "tiny");
  ASSERT_TRUE(without.ok());
  EXPECT_THAT(without->level->light_rgb, IsEmpty());
  EXPECT_THAT(without->notes, IsEmpty());
  const auto with = load_level(open_or_die(folder, {"mod", "light"}), "tiny");
  ASSERT_TRUE(with.ok());
  EXPECT_THAT(with->level->light_rgb, ::testing::Each(2));
}

TEST(LoadLevel, NotesMissingTextureOnce) {
  const test::TemporaryFolder folder;
  folder.write("id1/maps/tiny.bsp", pack_bytes(tiny_level(/*missing_texture=*/true)));
  const auto loaded = load_level(open_or_die(folder), "tiny");
  ASSERT_TRUE(loaded.ok()) << loaded.error().message();
  EXPECT_THAT(loaded->notes, ElementsAre(HasSubstr("tiny: missing textures, drawn as a checkerboard: ")));
}

TEST(LoadLevel, MissingLevelIsNotFound) {
  const test::TemporaryFolder folder;
  folder.write("id1/maps/other.bsp", "");
  const auto loaded = load_level(open_or_die(folder), "tiny");
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().code, base::ErrorCode::kNotFound);
  EXPECT_THAT(loaded.error().message(), HasSubstr("maps/tiny.bsp"));
}

TEST(LoadLevel, NamesArchiveOfDamagedLevel) {
  const test::TemporaryFolder folder;
  folder.write(
      "id1/pak0.pak",
      formats::write_pak(std::vector<formats::ArchiveFile>{{"maps/tiny.bsp", base::as_bytes("not a level")}})
          .value());
  const auto loaded = load_level(open_or_die(folder), "tiny");
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().file, "maps/tiny.bsp in " + (folder.path() / "id1" / "pak0.pak").string());
}

TEST(LoadLevelFile, LoadsLightNextToLevel) {
  const formats::Bsp bsp = tiny_level();
  const test::TemporaryFolder folder;
  const auto path = folder.write("somewhere/tiny.bsp", pack_bytes(bsp));
  const auto plain = load_level_file(path);
  ASSERT_TRUE(plain.ok()) << plain.error().message();
  EXPECT_EQ(plain->level->name, "tiny");
  EXPECT_THAT(plain->level->light_rgb, IsEmpty());
  folder.write("somewhere/tiny.lit", lit_for(bsp, 9));
  const auto colored = load_level_file(path);
  ASSERT_TRUE(colored.ok());
  EXPECT_THAT(colored->level->light_rgb, ::testing::Each(9));
}

// The files next to a level that replace parts of it, in a folder of the game or on disk.
class LevelAdditions : public ::testing::TestWithParam<bool> {
 protected:
  LevelAdditions() { folder_.write("id1/maps/tiny.bsp", pack_bytes(bsp_)); }
  void add(const std::string& suffix, const base::ByteVector& bytes) {
    folder_.write("id1/maps/tiny" + suffix, bytes);
  }
  LoadedLevel load() const {
    auto loaded = GetParam() ? load_level(open_or_die(folder_), "tiny")
                             : load_level_file(folder_.path() / "id1/maps/tiny.bsp");
    CHECK(loaded.ok(), "{}", loaded.error().message());
    return std::move(loaded).value();
  }

  formats::Bsp bsp_ = tiny_level();
  test::TemporaryFolder folder_;
};

TEST_P(LevelAdditions, ReplaceEntities) {
  add(".ent", test::to_bytes("{\n\"classname\" \"worldspawn\"\n\"message\" \"patched\"\n}\n{ \"classname\" "
                             "\"light\" }\n"));
  const LoadedLevel loaded = load();
  ASSERT_EQ(loaded.level->entities.size(), 2u);
  EXPECT_EQ(loaded.level->entities[0].find("message"), "patched");
  EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST_P(LevelAdditions, ReplaceEntitiesInSpiteOfAFault) {
  add(".ent", test::to_bytes("{ \"classname\" \"worldspawn\"\n\"message\" \"patched\"\n"));
  const LoadedLevel loaded = load();
  ASSERT_EQ(loaded.level->entities.size(), 1u);
  EXPECT_EQ(loaded.level->entities[0].find("message"), "patched");
  EXPECT_THAT(loaded.notes, ElementsAre(AllOf(HasSubstr("tiny.ent: "), HasSubstr("line "))));
}

TEST_P(LevelAdditions, IgnoreTextWithoutWorldspawn) {
  for (const char* const text :
       {"no braces", "", "// nothing\n", "{ \"classname\"", "{ \"classname\" \"light\" }"}) {
    add(".ent", test::to_bytes(text));
    const LoadedLevel loaded = load();
    EXPECT_EQ(loaded.level->entities, formats::read_entities(bsp_.entities).value()) << text;
    EXPECT_THAT(loaded.notes, ElementsAre(AllOf(HasSubstr("tiny.ent"), HasSubstr("ignored")))) << text;
  }
}

// A level without visibility, and a patch with that of the complete level.
TEST_P(LevelAdditions, ReplaceVisibility) {
  std::vector<std::int32_t> offsets;
  for (formats::BspLeaf& leaf : bsp_.leaves) offsets.push_back(leaf.visibility_offset);
  const world::Level complete = *load().level;
  ASSERT_FALSE(bsp_.visibility.empty());
  add(".vis", test::vis_patch_bytes("TINY.BSP", bsp_.visibility, offsets));
  for (formats::BspLeaf& leaf : bsp_.leaves) leaf.visibility_offset = -1;
  bsp_.visibility.clear();
  add(".bsp", pack_bytes(bsp_));
  const LoadedLevel loaded = load();
  EXPECT_THAT(loaded.notes, IsEmpty());
  EXPECT_EQ(loaded.level->visibility, complete.visibility);
  ASSERT_EQ(loaded.level->leaves.size(), complete.leaves.size());
  for (std::size_t leaf = 0; leaf < complete.leaves.size(); ++leaf)
    EXPECT_EQ(loaded.level->leaves[leaf].visibility_offset, complete.leaves[leaf].visibility_offset) << leaf;
}

TEST_P(LevelAdditions, IgnoreVisibilityOfOtherLevels) {
  const std::vector<std::int32_t> offsets(bsp_.leaves.size(), -1), too_few(bsp_.leaves.size() - 1, -1);
  for (const base::ByteVector& patch :
       {test::vis_patch_bytes("other.bsp", {}, offsets), test::vis_patch_bytes("tiny.bsp", {}, too_few),
        test::to_bytes("no patch")}) {
    add(".vis", patch);
    const LoadedLevel loaded = load();
    EXPECT_EQ(loaded.level->visibility, bsp_.visibility);
    EXPECT_THAT(loaded.notes, ElementsAre(AllOf(HasSubstr("tiny.vis"), HasSubstr("ignored"))));
  }
}

INSTANTIATE_TEST_SUITE_P(Places, LevelAdditions, ::testing::Bool());

TEST(LoadLevelFile, IgnoresUnreadableLightWithNote) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("tiny.bsp", pack_bytes(tiny_level()));
  folder.write("tiny.lit/inside", test::to_bytes("a folder"));
  const auto loaded = load_level_file(path);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message();
  EXPECT_THAT(loaded->notes, ElementsAre(AllOf(HasSubstr("tiny.lit"), HasSubstr("ignored"))));
}

TEST(LoadLevelFile, NotesNameTheFile) {
  const test::TemporaryFolder folder;
  formats::Bsp bsp = tiny_level();
  bsp.entities += "{ \"classname\"";
  const auto loaded = load_level_file(folder.write("tiny.bsp", pack_bytes(bsp)));
  ASSERT_TRUE(loaded.ok()) << loaded.error().message();
  EXPECT_THAT(loaded->notes, ElementsAre(AllOf(HasSubstr("tiny.bsp: lump entities: line "),
                                               HasSubstr("the key \"classname\" has no value"))));
}

TEST(LoadLevelFile, ErrorsNameTheFile) {
  const test::TemporaryFolder folder;
  const auto missing = load_level_file(folder.path() / "none.bsp");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, base::ErrorCode::kNotFound);
  EXPECT_EQ(missing.error().file, (folder.path() / "none.bsp").string());
  const auto damaged = load_level_file(folder.write("damaged.bsp", "junk"));
  ASSERT_FALSE(damaged.ok());
  EXPECT_EQ(damaged.error().file, (folder.path() / "damaged.bsp").string());
  EXPECT_FALSE(load_level_file(folder.path()).ok());
}

TEST(LoadLook, ReadsPaletteAndColormap) {
  test::Random random(5);
  const base::ByteVector palette = test::random_bytes(random, 768);
  const base::ByteVector colormap = test::random_bytes(random, 16385);
  const test::TemporaryFolder folder;
  folder.write("id1/gfx/palette.lmp", palette);
  folder.write("id1/gfx/colormap.lmp", colormap);
  const auto look = load_look(open_or_die(folder));
  ASSERT_TRUE(look.ok()) << look.error().message();
  EXPECT_EQ(formats::write_palette(look->palette), palette);
  EXPECT_EQ(formats::write_colormap(look->colormap), colormap);
}

TEST(LoadLook, ComputesMissingColormap) {
  const test::TemporaryFolder folder;
  folder.write("id1/gfx/palette.lmp", base::ByteVector(768, std::byte{128}));
  const auto look = load_look(open_or_die(folder));
  ASSERT_TRUE(look.ok());
  // All colors are the same, so lit colors become the lowest index; fullbright ones stay.
  EXPECT_EQ(look->colormap.rows[31 * 256 + 100], 0);
  EXPECT_EQ(look->colormap.rows[31 * 256 + 250], 250);
}

TEST(LoadLook, ErrorsNameTheFile) {
  const test::TemporaryFolder folder;
  folder.write("id1/a", "");
  const auto missing = load_look(open_or_die(folder));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, base::ErrorCode::kNotFound);
  EXPECT_EQ(missing.error().file, "gfx/palette.lmp");
  const auto path = folder.write("id1/gfx/palette.lmp", "short");
  const auto damaged = load_look(open_or_die(folder));
  ASSERT_FALSE(damaged.ok());
  EXPECT_EQ(damaged.error().file, path.string());
}

TEST(LoadLevel, LoadsStockLevelsWithoutNotes) {
  DATA_FOLDER_OR_SKIP(data);
  const auto files = vfs::FileSystem::open(data);
  ASSERT_TRUE(files.ok()) << files.error().message();
  EXPECT_TRUE(load_look(*files).ok());
  std::vector<std::string> names = files->list("maps/", ".bsp");
  ASSERT_FALSE(names.empty());
  if (test::kQuick) names = {"maps/start.bsp"};
  for (const std::string& name : names) {
    const std::string map_name = name.substr(5, name.size() - 9);
    const auto loaded = load_level(*files, map_name);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message();
    EXPECT_THAT(loaded->notes, IsEmpty()) << name;
    const bool colored = files->contains("maps/" + map_name + ".lit");
    EXPECT_EQ(loaded->level->light_rgb.size(), colored ? 3 * loaded->level->light.size() : 0) << name;
  }
}

}  // namespace
}  // namespace temblor::assets
