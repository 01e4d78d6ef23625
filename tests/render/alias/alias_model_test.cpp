// AliasModel against the numbers of the file that it is made from.
#include "render/alias_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "render/alias/alias_mesh.h"
#include "support/game_data.h"
#include "support/models/drawable_models.h"
#include "support/models/small_models.h"

namespace temblor::test {
namespace {

// Corner by corner: position, normal, and skin position are those of the file.
void expect_same_mesh(const formats::Mdl& mdl) {
  const auto model = render::make_alias_model(mdl, "test");
  ASSERT_EQ(model->triangles.size(), mdl.triangles.size());
  std::vector<const formats::MdlPose*> poses;
  for (const formats::MdlFrame& frame : mdl.frames)
    for (const formats::MdlPose& pose : frame.poses) poses.push_back(&pose);
  ASSERT_EQ(model->pose_count(), poses.size());
  const math::Bounds& bounds = render::model_bounds(*model);
  for (std::size_t number = 0; number < poses.size(); ++number) {
    const render::PoseBytes pose = model->pose(base::to_index<render::PoseIndex>(number));
    for (std::size_t i = 0; i < mdl.triangles.size(); ++i)
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t from = mdl.triangles[i].vertices[corner];
        const std::uint32_t to = model->triangles[i][corner];
        ASSERT_LT(to, model->vertex_count);
        const formats::MdlVertex& expected = poses[number]->vertices[from];
        ASSERT_EQ(pose.x[to], expected.position[0]);
        ASSERT_EQ(pose.y[to], expected.position[1]);
        ASSERT_EQ(pose.z[to], expected.position[2]);
        ASSERT_EQ(pose.normals[to], expected.normal);
        const math::Vec3 position =
            math::Vec3(expected.position[0], expected.position[1], expected.position[2]) * mdl.scale +
            mdl.origin;
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(position[axis], bounds.mins[axis]);
          ASSERT_LE(position[axis], bounds.maxs[axis]);
        }
        const formats::MdlTexel& texel = mdl.texels[from];
        const bool shifted = texel.on_seam && !mdl.triangles[i].faces_front;
        const double s = texel.s + (shifted ? mdl.skin_width / 2 : 0.0);
        ASSERT_EQ(model->texels[to].s, std::clamp(s, 0.0, mdl.skin_width - 1.0) + 0.5);
        ASSERT_EQ(model->texels[to].t, std::clamp(texel.t + 0.0, 0.0, mdl.skin_height - 1.0) + 0.5);
      }
  }
}

TEST(AliasModel, HasTheFilesMesh) {
  expect_same_mesh(box_mdl());
  expect_same_mesh(sphere_mdl());
  expect_same_mesh(many_pose_mdl());
  expect_same_mesh(small_mdl());
}

TEST(AliasModel, OfStockFilesHasTheirMesh) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"ogre", "player", "boss", "flame2", "v_rock"}) {
    SCOPED_TRACE(name);
    expect_same_mesh(
        formats::read_mdl(read_file(data / "id1" / "progs" / (std::string(name) + ".mdl"))).value());
  }
}

TEST(AliasModel, SplitsSeamVerticesThatBothSidesUse) {
  formats::Mdl mdl = sphere_mdl();
  // Two rings of seam vertices, pole to pole.
  std::size_t on_seam = 0;
  for (const formats::MdlTexel& texel : mdl.texels) on_seam += texel.on_seam;
  EXPECT_EQ(render::make_alias_model(mdl, "test")->vertex_count, mdl.texels.size() + on_seam);
  for (formats::MdlTriangle& triangle : mdl.triangles) triangle.faces_front = true;
  EXPECT_EQ(render::make_alias_model(mdl, "test")->vertex_count, mdl.texels.size());
}

TEST(AliasModel, TexelsBeyondTheSkinAreItsEdge) {
  formats::Mdl mdl = box_mdl();
  mdl.texels[0] = {false, -1000000, 2000000000};
  mdl.texels[7] = {true, 2147483647, -2147483647 - 1};
  mdl.triangles[0].faces_front = false;
  expect_same_mesh(mdl);
}

TEST(AliasModel, FramesAndSkinsFollowTheirTimes) {
  const formats::Mdl mdl = small_mdl();
  const auto model = render::make_alias_model(mdl, "small");
  EXPECT_EQ(render::model_name(*model), "small");
  EXPECT_EQ(render::find_model_flags(*model), mdl.flags);
  EXPECT_EQ(render::frame_count(*model), 2u);
  EXPECT_EQ(render::skin_count(*model), 2u);
  EXPECT_EQ(render::pose_at(*model, 0, 123), render::PoseIndex{0});
  // The group's members end at 0.1, 0.2, and 0.5 s, and then it begins again.
  EXPECT_EQ(render::pose_at(*model, 1, 0.05), render::PoseIndex{1});
  EXPECT_EQ(render::pose_at(*model, 1, 0.15), render::PoseIndex{2});
  EXPECT_EQ(render::pose_at(*model, 1, 0.45), render::PoseIndex{3});
  EXPECT_EQ(render::pose_at(*model, 1, 0.55), render::PoseIndex{1});
  EXPECT_EQ(render::pose_at(*model, 2, 0.15), render::PoseIndex{0}) << "a frame that is not there";
  EXPECT_EQ(render::skin_at(*model, 1, 0.1), 1u);
  EXPECT_EQ(render::skin_at(*model, 1, 0.9), 2u);
  EXPECT_EQ(render::skin_at(*model, 77, 0.9), 0u);
  EXPECT_EQ(*model->skin_picture(2), mdl.skins[1].pictures[1][0]);
}

}  // namespace
}  // namespace temblor::test
