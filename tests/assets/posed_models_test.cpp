// MD3 and MD5 models in game directories made for the test.
#include "assets/posed_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assets/assets.h"
#include "formats/images/image.h"
#include "formats/images/nearest_color.h"
#include "formats/images/png.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/models/small_models.h"
#include "support/programs/small_game.h"

namespace temblor::assets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class PosedModels : public ::testing::Test {
 protected:
  void SetUp() override { write_model("id1"); }

  void write_model(const std::string& game) {
    const test::Md5Sample sample = test::bending_column(6, 4, 3, "column");
    write(game + "/progs/column.md5mesh", sample.mesh);
    write(game + "/progs/column.md5anim", sample.animation);
    game_.folder().write(game + "/progs/column.mdl", formats::write_mdl(test::small_mdl()));
  }
  void write(const std::string& name, std::string_view text) { game_.folder().write(name, text); }
  // A picture of one color.
  void write_skin(const std::string& name, std::uint8_t color, std::uint32_t side = 2) {
    game_.folder().write(name, formats::write_picture(
                                   {side, side, std::vector<std::uint8_t>(std::size_t{side} * side, color)}));
  }
  vfs::FileSystem files(const std::vector<std::string>& games = {}) {
    return vfs::FileSystem::open(game_.path(), games).value();
  }
  base::Result<std::optional<formats::PosedModel>> load_replacement(
      const std::vector<std::string>& games = {}) {
    return load_md5_replacement(files(games), "progs/column.mdl", test::small_mdl());
  }
  // The first texel of each picture, skin by skin.
  static std::vector<std::vector<int>> colors(const formats::PosedModel& model) {
    std::vector<std::vector<int>> all;
    for (const formats::PosedSkin& skin : model.skins) {
      std::vector<int>& members = all.emplace_back();
      for (const auto& pictures : skin.pictures) members.push_back(pictures.front().pixels.front());
    }
    return all;
  }

  test::SmallGame game_;
  std::vector<std::string> notes_;
};

TEST_F(PosedModels, Md5ReplacesMdlWithItsFramesAndSkins) {
  write_skin("id1/progs/column_00_00.lmp", 1);
  write_skin("id1/progs/column_01_00.lmp", 2);
  write_skin("id1/progs/column_01_01.lmp", 3);
  write_skin("id1/progs/column_03_00.lmp", 4);  // after a gap
  const auto model = load_replacement().value();
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(model->pose_count, 3u);
  EXPECT_EQ(model->frames.size(), test::small_mdl().frames.size());
  EXPECT_EQ(model->flags, test::small_mdl().flags);
  EXPECT_THAT(colors(*model), ElementsAre(ElementsAre(1), ElementsAre(2, 3)));
  // The MDL file's second skin is a group of two as well.
  EXPECT_EQ(model->skins[1].end_times_s, test::small_mdl().skins[1].end_times_s);
}

TEST_F(PosedModels, AMissingSkinIsAnErrorThatNamesIt) {
  const auto model = load_replacement();
  ASSERT_FALSE(model.ok());
  EXPECT_THAT(model.error().message(), HasSubstr("column.md5mesh: its skin column is missing"));
}

TEST_F(PosedModels, ADamagedSkinIsAnErrorThatNamesIt) {
  write("id1/progs/column_00_00.lmp", "short");
  EXPECT_THAT(load_replacement().error().message(), HasSubstr("column_00_00.lmp"));
  write("id1/progs/column_00_00.tga", "short");
  EXPECT_THAT(load_replacement().error().message(), HasSubstr("column_00_00.tga"));
}

TEST_F(PosedModels, OnlyAnMd5ModelOfTheSameOrAHigherGameReplaces) {
  write_skin("id1/progs/column_00_00.lmp", 1);
  game_.folder().write("mod/progs/column.mdl", formats::write_mdl(test::small_mdl()));
  EXPECT_FALSE(load_replacement({"mod"}).value().has_value()) << "an older game's";
  write_model("mod");
  EXPECT_TRUE(load_replacement({"mod"}).value().has_value());
  write("higher/progs/column.md5mesh", test::bending_column(6, 4, 3, "column").mesh);
  EXPECT_TRUE(load_replacement({"mod", "higher"}).value().has_value());
}

TEST_F(PosedModels, WithoutBothFilesThereIsNoReplacement) {
  std::filesystem::remove(game_.path() / "id1/progs/column.md5anim");
  EXPECT_FALSE(load_replacement().value().has_value());
  EXPECT_FALSE(load_md5_replacement(files(), "progs/column.spr", {}).value().has_value());
}

TEST_F(PosedModels, DamagedFilesAreErrorsThatNameThem) {
  write_skin("id1/progs/column_00_00.lmp", 1);
  write("id1/progs/column.md5anim", "MD5Version 10");
  EXPECT_THAT(load_replacement().error().message(), HasSubstr("column.md5anim: line 1"));
  write("id1/progs/column.md5mesh", "MD5Version 11");
  EXPECT_THAT(load_replacement().error().message(), HasSubstr("column.md5mesh: line 1"));
}

TEST_F(PosedModels, TrueColorSkinsAreMatchedToColorsThatLightChanges) {
  const formats::Palette palette = load_look(files()).value().palette;
  const formats::Rgb bright = palette[250];
  const std::uint32_t pixel =
      0xff000000u | std::uint32_t{bright.r} << 16 | std::uint32_t{bright.g} << 8 | bright.b;
  const formats::Image image{2, 1, {pixel, pixel}};
  game_.folder().write("id1/progs/column_00_00.png", formats::write_png(image).value());
  const int matched = colors(*load_replacement().value())[0][0];
  EXPECT_LT(matched, 224);
  const formats::NearestColor nearest(palette, 0, 224);
  EXPECT_EQ(matched, nearest.find(bright));
  // TGA is first in order.
  game_.folder().write("id1/progs/column_00_00.tga", formats::write_tga({1, 1, {0xff000000u}}));
  EXPECT_EQ(colors(*load_replacement().value())[0][0], nearest.find({0, 0, 0}));
}

TEST_F(PosedModels, AnMd3ModelFindsTheSkinsThatItNames) {
  formats::Md3 md3 = test::convert_to_md3(test::box_mdl(), "models/gem/red.tga");
  md3.surfaces[0].shaders.push_back("c:\\work\\blue.jpg");
  game_.folder().write("id1/models/gem/gem.md3", test::write_md3(md3));
  write_skin("id1/models/gem/red.lmp", 5);
  write_skin("id1/models/gem/blue.lmp", 6);
  const formats::PosedModel model = load_posed_model(files(), "models/gem/gem.md3", notes_).value();
  EXPECT_THAT(notes_, IsEmpty());
  EXPECT_THAT(colors(model), ElementsAre(ElementsAre(5), ElementsAre(6)));
}

TEST_F(PosedModels, AModelThatReplacesNothingHasACheckerboardForASkin) {
  game_.folder().write("id1/models/gem.md3",
                       test::write_md3(test::convert_to_md3(test::box_mdl(), "models/red")));
  const formats::PosedModel model = load_posed_model(files(), "models/gem.md3", notes_).value();
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("gem.md3: its skin models/red is missing")));
  EXPECT_EQ(model.skins.size(), 1u);
  EXPECT_EQ(load_posed_model(files(), "progs/column.md5mesh", notes_).value().frames.size(), 3u);
  EXPECT_FALSE(load_posed_model(files(), "models/none.md3", notes_).ok());
}

TEST_F(PosedModels, AreMeasuredInAllFrames) {
  const formats::Mdl mdl = test::many_pose_mdl(4);
  game_.folder().write("id1/models/ball.md3", test::write_md3(test::convert_to_md3(mdl, "x")));
  math::Bounds expected{math::Vec3(1e9f), math::Vec3(-1e9f)};
  for (const formats::MdlFrame& frame : mdl.frames)
    for (const formats::MdlPose& pose : frame.poses)
      for (const formats::MdlVertex& vertex : pose.vertices) {
        const math::Vec3 place =
            mdl.scale * math::Vec3(vertex.position[0], vertex.position[1], vertex.position[2]) + mdl.origin;
        expected.mins = glm::min(expected.mins, place);
        expected.maxs = glm::max(expected.maxs, place);
      }
  const math::Bounds bounds = measure_posed_model(files(), "models/ball.md3").value();
  EXPECT_EQ(bounds.mins, expected.mins);
  EXPECT_EQ(bounds.maxs, expected.maxs);
  EXPECT_GT(measure_posed_model(files(), "progs/column.md5mesh").value().maxs.z, 80);
  EXPECT_TRUE(is_posed_model("models/BALL.MD3") && is_posed_model("progs/column.md5mesh"));
  EXPECT_FALSE(is_posed_model("progs/column.mdl"));
}

}  // namespace
}  // namespace temblor::assets
