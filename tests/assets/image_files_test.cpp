// Pictures in color: which file is found, and what replaces the game's own pictures and skins.
#include "assets/image_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artgen/palette.h"
#include "assets/library.h"
#include "formats/archives/wad.h"
#include "formats/images/png.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::assets {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::uint32_t kOrange = 0xffc05010, kTeal = 0xff107070;

formats::Image solid(std::uint32_t color, std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::uint32_t>(std::size_t{width} * height, color)};
}
base::ByteVector png(const formats::Image& image) {
  return formats::write_png(image).value();
}
base::ByteVector jpeg() {
  return test::read_file(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "fuzz/corpus/jpeg/baseline.jpg");
}

class ImageFiles : public testing::Test {
 protected:
  ImageFiles() { write("id1/gfx/palette.lmp", formats::write_palette(artgen::make_palette())); }
  void write(std::string_view name, const base::ByteVector& bytes) { folder_.write(name, bytes); }
  vfs::FileSystem files(const std::vector<std::string>& games = {}) {
    return vfs::FileSystem::open(folder_.path(), games).value();
  }
  Pictures load_pictures(const std::vector<std::string>& games = {}) {
    notes_.clear();
    return Pictures::load(files(games), notes_);
  }
  formats::Mdl load_model(const std::vector<std::string>& games = {}) {
    notes_.clear();
    return Library(files(games)).alias_model_with_skins("progs/Box.mdl", notes_).value();
  }

  const test::TemporaryFolder folder_;
  std::vector<std::string> notes_;
};

TEST_F(ImageFiles, AreFoundByGameThenByExtension) {
  EXPECT_EQ(find_image_file(files(), "a/b"), "");
  write("id1/a/b.jpg", jpeg());
  EXPECT_EQ(find_image_file(files(), "a/b"), "a/b.jpg");
  write("id1/a/b.png", png(solid(kTeal, 1, 1)));
  EXPECT_EQ(find_image_file(files(), "a/b"), "a/b.png");
  write("mod/a/b.jpg", jpeg());
  EXPECT_EQ(find_image_file(files({"mod"}), "a/b"), "a/b.jpg");
  EXPECT_EQ(read_image_file(files({"mod"}), "a/b.jpg")->width, 32u);
  write("id1/a/c.jpg", base::ByteVector(9));
  EXPECT_THAT(read_image_file(files(), "a/c.jpg").error().message(), HasSubstr("c.jpg"));
}

TEST_F(ImageFiles, ReplacePicturesOfTheWadAndOfFiles) {
  const base::ByteVector lump = formats::write_picture({2, 1, {3, 4}});
  write("id1/gfx.wad",
        formats::write_wad(std::vector<formats::WadLump>{{"TURTLE", formats::kWadPicture, lump}}).value());
  write("id1/gfx/conback.lmp", formats::write_picture({4, 2, std::vector<std::uint8_t>(8, 5)}));
  EXPECT_EQ(load_pictures().find("turtle")->detail, nullptr);
  write("id1/gfx/turtle.png", png(solid(kOrange, 8, 4)));
  write("id1/gfx/conback.jpg", jpeg());
  write("id1/gfx/conchars.tga", formats::write_tga(solid(0x07ffffff, 256, 256)));
  write("id1/gfx/unknown.png", png(solid(kOrange, 1, 1)));
  const Pictures pictures = load_pictures();
  const formats::Picture& turtle = *pictures.find("turtle");
  EXPECT_EQ(turtle.width, 2u) << "the size stays";
  ASSERT_NE(turtle.detail, nullptr);
  EXPECT_EQ(turtle.detail->width, 8u);
  EXPECT_THAT(turtle.detail->colors, Each(kOrange));
  const formats::NearestColor nearest(artgen::make_palette(), 0, 255);
  EXPECT_THAT(turtle.detail->indices, Each(nearest.find({0xc0, 0x50, 0x10})));
  EXPECT_EQ(pictures.find("gfx/conback.lmp")->detail->width, 32u);
  EXPECT_THAT(pictures.characters().detail->indices, Each(255)) << "nearly clear";
  EXPECT_EQ(pictures.find("gfx/unknown.lmp"), nullptr);
}

TEST_F(ImageFiles, ReplaceMissingPictures) {
  EXPECT_EQ(load_pictures().find_real("gfx/conback.lmp"), nullptr);
  write("id1/gfx/conback.png", png(solid(kTeal, 640, 400)));
  const Pictures pictures = load_pictures();
  ASSERT_NE(pictures.find_real("gfx/conback.lmp"), nullptr);
  EXPECT_NE(pictures.find("gfx/conback.lmp")->detail, nullptr);
  EXPECT_THAT(notes_, Each(Not(HasSubstr("conback"))));
}

TEST_F(ImageFiles, OfLowerGameFoldersReplaceNothing) {
  write("id1/gfx/conback.png", png(solid(kTeal, 640, 400)));
  write("mod/gfx/conback.lmp", formats::write_picture({4, 2, std::vector<std::uint8_t>(8, 5)}));
  EXPECT_EQ(load_pictures({"mod"}).find("gfx/conback.lmp")->detail, nullptr);
}

TEST_F(ImageFiles, ThatAreDamagedAreNoted) {
  write("id1/gfx/conback.png", base::ByteVector(40));
  const Pictures pictures = load_pictures();
  EXPECT_EQ(pictures.find("gfx/conback.lmp")->detail, nullptr);
  EXPECT_THAT(notes_, Contains(AllOf(HasSubstr("damaged"), HasSubstr("conback.png"))));
}

// A triangle with two skins of 4 x 2 texels.
formats::Mdl make_model() {
  formats::Mdl mdl;
  mdl.skin_width = 4;
  mdl.skin_height = 2;
  mdl.skins.assign(2, {{std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5, 6, 7}}, {}});
  mdl.texels = {{false, 0, 0}, {true, 3, 0}, {false, 0, 1}};
  mdl.triangles = {{true, {0, 1, 2}}};
  mdl.frames.resize(1);
  mdl.frames[0].poses.resize(1);
  mdl.frames[0].poses[0].vertices.resize(3);
  return mdl;
}

TEST_F(ImageFiles, ReplaceSkins) {
  write("id1/progs/box.mdl", formats::write_mdl(make_model()));
  EXPECT_EQ(load_model(), make_model());
  write("id1/progs/box_1.png", png(solid(kOrange, 4, 2)));
  const formats::NearestColor nearest(artgen::make_palette(), 0, formats::kFirstFullbright);
  const std::uint8_t orange = nearest.find({0xc0, 0x50, 0x10}), teal = nearest.find({0x10, 0x70, 0x70});
  formats::Mdl expected = make_model();
  expected.skins[1].pictures[0].assign(8, orange);
  EXPECT_EQ(load_model(), expected);
  write("id1/progs/box.mdl_1.tga", formats::write_tga(solid(kTeal, 4, 2)));
  EXPECT_THAT(load_model().skins[1].pictures[0], Each(teal)) << "the longer name takes precedence";
  EXPECT_THAT(notes_, IsEmpty());
}

TEST_F(ImageFiles, EnlargeSkins) {
  write("id1/progs/box.mdl", formats::write_mdl(make_model()));
  write("id1/progs/box_0.png", png(solid(kOrange, 9, 5)));
  const formats::Mdl mdl = load_model();
  EXPECT_EQ(mdl.skin_width, 8u);
  EXPECT_EQ(mdl.skin_height, 4u);
  EXPECT_EQ(mdl.skins[0].pictures[0].size(), 32u);
  EXPECT_EQ(mdl.skins[1].pictures[0],
            (std::vector<std::uint8_t>{0, 0, 1, 1, 2, 2, 3, 3, 0, 0, 1, 1, 2, 2, 3, 3,
                                       4, 4, 5, 5, 6, 6, 7, 7, 4, 4, 5, 5, 6, 6, 7, 7}));
  EXPECT_EQ(mdl.texels[1], (formats::MdlTexel{true, 7, 1}));
  EXPECT_TRUE(formats::read_mdl(formats::write_mdl(mdl)).ok()) << "it is still a valid model";
}

TEST_F(ImageFiles, OfLowerFoldersAndDamagedOnesLeaveTheSkin) {
  write("id1/progs/box_0.png", png(solid(kOrange, 4, 2)));
  write("mod/progs/box.mdl", formats::write_mdl(make_model()));
  write("mod/progs/box_1.png", base::ByteVector(3));
  EXPECT_EQ(load_model({"mod"}), make_model());
  EXPECT_THAT(notes_, Contains(AllOf(HasSubstr("box_1.png"), HasSubstr("own skin"))));
}

}  // namespace
}  // namespace temblor::assets
