// Precache lists with game directories made for the test: files present, missing and damaged.
#include "client/session/model_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/session/placeholder_model.h"
#include "formats/models/mdl.h"
#include "formats/models/spr.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/programs/small_game.h"

namespace temblor::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

formats::Spr one_texel_sprite() {
  formats::Spr sprite;
  sprite.max_width = sprite.max_height = 1;
  sprite.frames = {{{{0, 0, 1, 1, {7}}}, {}}};
  return sprite;
}

class ModelTableTest : public ::testing::Test {
 protected:
  void SetUp() override {
    formats::Mdl mdl = make_placeholder_model();
    mdl.flags = formats::kMdlRotate;
    game_.folder().write("id1/progs/cube.mdl", formats::write_mdl(mdl));
    game_.folder().write("id1/progs/spot.spr", formats::write_spr(one_texel_sprite()));
    game_.folder().write("id1/progs/damaged.mdl", std::string_view("IDPO and then nothing"));
    game_.folder().write("id1/maps/b_box.bsp", game_.level_bytes(formats::BspVersion::k29));
  }
  base::Result<ModelTable> load(const std::vector<std::string>& names) {
    const assets::Library library(vfs::FileSystem::open(game_.path()).value());
    return ModelTable::load(library, names, {}, notes_);
  }

  test::SmallGame game_;
  std::vector<std::string> notes_;
};

TEST_F(ModelTableTest, EachKindIsLoaded) {
  const ModelTable table =
      load({"", "maps/small.bsp", "*1", "progs/cube.mdl", "progs/spot.spr", "maps/b_box.bsp"}).value();
  EXPECT_THAT(notes_, IsEmpty());
  EXPECT_EQ(std::get<world::ModelIndex>(table.model(1)), world::ModelIndex{0});
  EXPECT_EQ(std::get<world::ModelIndex>(table.model(2)), world::ModelIndex{1});
  EXPECT_EQ(render::model_name(*std::get<AliasModelPtr>(table.model(3))), "progs/cube.mdl");
  EXPECT_EQ(*std::get<SpritePtr>(table.model(4)), one_texel_sprite());
  const auto own_models = static_cast<std::uint32_t>(game_.level().models.size());
  EXPECT_EQ(std::get<world::ModelIndex>(table.model(5)), world::ModelIndex{own_models});
  EXPECT_EQ(table.level()->models.size(), 2 * own_models);
  EXPECT_THAT(table.flags(), ElementsAre(0, 0, 0, formats::kMdlRotate, 0, 0));
}

TEST_F(ModelTableTest, MissingAndDamagedModelsBecomeNotedCubes) {
  const ModelTable table = load({"", "maps/small.bsp", "progs/none.mdl", "progs/damaged.mdl", "*99", "*x",
                                 "maps/b_none.bsp", "progs/none.spr", ""})
                               .value();
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("progs/none.mdl"), HasSubstr("damaged.mdl"), HasSubstr("*99"),
                                  HasSubstr("*x"), HasSubstr("maps/b_none.bsp"), HasSubstr("progs/none.spr"),
                                  HasSubstr("placeholder is drawn")));
  for (std::size_t number = 2; number <= 8; ++number)
    EXPECT_EQ(render::model_name(*std::get<AliasModelPtr>(table.model(number))), "missing model") << number;
}

TEST_F(ModelTableTest, NumbersPastTheListGetACube) {
  const ModelTable table = load({"", "maps/small.bsp"}).value();
  EXPECT_FALSE(table.contains(2));
  EXPECT_EQ(render::model_name(*std::get<AliasModelPtr>(table.model(2))), "missing model");
}

TEST_F(ModelTableTest, FailsWithoutItsLevel) {
  for (const char* level : {"maps/none.bsp", "progs/cube.mdl", ""}) {
    const base::Result<ModelTable> table = load({"", level});
    ASSERT_FALSE(table.ok());
    EXPECT_EQ(table.error().file, level);
  }
  EXPECT_FALSE(load({""}).ok());
  EXPECT_FALSE(load({}).ok());
}

// r_md5 chooses between both at once, because both are loaded.
TEST_F(ModelTableTest, Md5ModelsAreLoadedNextToMdlFiles) {
  const test::Md5Sample sample = test::bending_column(6, 4, 3, "cube");
  for (const std::string name : {"cube", "bolt"}) {
    game_.folder().write("id1/progs/" + name + ".md5mesh", sample.mesh);
    game_.folder().write("id1/progs/" + name + ".md5anim", sample.animation);
  }
  game_.folder().write("id1/progs/bolt.mdl", formats::write_mdl(make_placeholder_model()));
  game_.folder().write("id1/progs/cube_00_00.lmp", formats::write_picture({1, 1, {1}}));
  const std::vector<std::string> names = {"", "maps/small.bsp", "progs/cube.mdl", "progs/spot.spr"};
  const ModelTable table = load(names).value();
  EXPECT_THAT(notes_, IsEmpty());
  const render::AliasModel *mdl = table.alias_model(2, false), *md5 = table.alias_model(2, true);
  EXPECT_EQ(mdl, std::get<AliasModelPtr>(table.model(2)).get());
  EXPECT_NE(mdl, md5);
  EXPECT_GT(render::model_bounds(*md5).maxs.z, 80);
  EXPECT_EQ(render::frame_count(*md5), render::frame_count(*mdl));
  EXPECT_EQ(table.flags()[2], formats::kMdlRotate);
  EXPECT_EQ(table.alias_model(3, true), nullptr) << "a sprite";
  EXPECT_EQ(table.alias_model(99, true), table.alias_model(99, false)) << "the placeholder";
  EXPECT_NE(table.beam(BeamModel::kBolt, true), table.beam(BeamModel::kBolt, false));
  EXPECT_EQ(table.beam(BeamModel::kBolt2, true), nullptr);
}

TEST_F(ModelTableTest, UnusableMd5ModelsAreNotedAndTheMdlFileIsDrawn) {
  const test::Md5Sample sample = test::bending_column(6, 4, 3, "none");
  game_.folder().write("id1/progs/cube.md5mesh", sample.mesh);
  game_.folder().write("id1/progs/cube.md5anim", sample.animation);
  const ModelTable table = load({"", "maps/small.bsp", "progs/cube.mdl"}).value();
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("skin none is missing")));
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("progs/cube.mdl is drawn instead")));
  EXPECT_EQ(table.alias_model(2, true), table.alias_model(2, false));
}

TEST_F(ModelTableTest, Md3ModelsAreLoadedByName) {
  formats::Md3 md3 = test::convert_to_md3(test::box_mdl(), "models/gem");
  md3.flags = formats::kMdlRotate;
  game_.folder().write("id1/models/gem.md3", test::write_md3(md3));
  game_.folder().write("id1/models/gem.lmp", formats::write_picture({1, 1, {1}}));
  game_.folder().write("id1/models/damaged.md3", std::string_view("IDP3"));
  const ModelTable table = load({"", "maps/small.bsp", "models/gem.md3", "models/damaged.md3"}).value();
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("damaged.md3")));
  EXPECT_EQ(render::model_name(*table.alias_model(2, true)), "models/gem.md3");
  EXPECT_EQ(render::model_name(*table.alias_model(3, true)), "missing model");
  EXPECT_EQ(table.flags()[2], formats::kMdlRotate);
}

// Every side of the cube faces outward: it is clockwise seen from outside.
TEST(PlaceholderModel, IsAClosedCube) {
  const formats::Mdl mdl = make_placeholder_model();
  const formats::Mdl again = formats::read_mdl(formats::write_mdl(mdl)).value();
  EXPECT_EQ(mdl, again);
  double volume = 0;
  for (const formats::MdlTriangle& triangle : mdl.triangles) {
    std::array<math::Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const formats::MdlVertex& vertex = mdl.frames[0].poses[0].vertices[triangle.vertices[i]];
      for (int axis = 0; axis < 3; ++axis)
        corners[i][axis] = static_cast<double>(
            mdl.scale[axis] * static_cast<float>(vertex.position[static_cast<std::size_t>(axis)]) +
            mdl.origin[axis]);
    }
    const math::Vec3d outward = glm::cross(corners[2] - corners[0], corners[1] - corners[0]);
    EXPECT_GT(glm::dot(outward, corners[0] + corners[1] + corners[2]), 0);
    volume += glm::dot(corners[0], glm::cross(corners[2], corners[1])) / 6;
  }
  const double side = 254.0 / 16.0;
  EXPECT_NEAR(volume, side * side * side, 1e-6);
}

}  // namespace
}  // namespace temblor::client
