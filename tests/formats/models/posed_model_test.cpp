// Baked poses against skinning by its definition, in double arithmetic and with matrices.
#include "formats/models/posed_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "formats/models/mdl_normals.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/models/small_models.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

struct Place {
  math::Vec3d position{0.0};
  glm::dmat3 turn{1.0};
};

// The rotation matrix of a quaternion.
glm::dmat3 to_matrix(const glm::quat& q) {
  const double w = static_cast<double>(q.w), x = static_cast<double>(q.x), y = static_cast<double>(q.y),
               z = static_cast<double>(q.z);
  return {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
          2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
          2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
}

// Puts each joint where its parents carry it.
std::vector<Place> place_joints(const std::vector<Md5Joint>& joints,
                                const std::vector<Md5JointPose>& relative) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    Place place{math::Vec3d(relative[i].position), to_matrix(relative[i].orientation)};
    if (joints[i].parent >= 0) {
      const Place& parent = places[static_cast<std::size_t>(joints[i].parent)];
      place = {parent.position + parent.turn * place.position, parent.turn * place.turn};
    }
    places.push_back(place);
  }
  return places;
}

// Not near half a turn: files leave w out, and near zero it is imprecise.
glm::quat random_turn(test::Random& io_random) {
  return glm::normalize(glm::quat(static_cast<float>(io_random.uniform(0.5, 1)), io_random.in_cube(1)));
}

struct RandomMd5 {
  explicit RandomMd5(std::uint64_t seed) {
    test::Random random(seed);
    const auto joints = static_cast<std::int32_t>(1 + random.below(12));
    for (std::int32_t i = 0; i < joints; ++i) {
      model.joints.push_back(
          {"j" + std::to_string(i),
           i == 0 ? -1 : static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(i)))});
      model.bind_pose.push_back({random.in_cube(20), random_turn(random)});
    }
    for (int i = 0; i < 5; ++i) {
      auto& frame = frames.emplace_back();
      for (std::int32_t joint = 0; joint < joints; ++joint)
        frame.push_back({random.in_cube(20), random_turn(random)});
    }
    for (int i = 0; i < 2; ++i) add_mesh(random);
  }

  void add_mesh(test::Random& io_random) {
    Md5Mesh& mesh = model.meshes.emplace_back();
    mesh.shader = "skin";
    for (int i = 0; i < 20; ++i) {
      const auto weights = static_cast<std::uint32_t>(1 + io_random.below(4));
      mesh.vertices.push_back({{0, 0}, static_cast<std::uint32_t>(mesh.weights.size()), weights});
      for (std::uint32_t weight = 0; weight < weights; ++weight)
        mesh.weights.push_back({static_cast<std::uint32_t>(io_random.below(model.joints.size())),
                                1.0f / static_cast<float>(weights), io_random.in_cube(10)});
    }
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  }

  Md5Model model;
  test::Md5Frames frames;
};

TEST(PosedModel, Md5VerticesAreWhereTheirJointsCarryThem) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMd5 random(seed);
    const Md5Model model = read_md5_model(test::write_md5_mesh(random.model)).value();
    const Md5Animation animation =
        read_md5_animation(test::write_md5_animation(random.model.joints, random.frames)).value();
    const PosedModel posed = pose_md5(model, animation).value();
    ASSERT_EQ(posed.pose_count, random.frames.size());
    ASSERT_EQ(posed.meshes.size(), 2u);
    for (std::size_t frame = 0; frame < random.frames.size(); ++frame) {
      const std::vector<Place> places = place_joints(random.model.joints, random.frames[frame]);
      for (std::size_t number = 0; number < 2; ++number) {
        const Md5Mesh& mesh = random.model.meshes[number];
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
          math::Vec3d expected{0.0};
          for (std::uint32_t w = 0; w < mesh.vertices[i].weight_count; ++w) {
            const Md5Weight& weight = mesh.weights[mesh.vertices[i].first_weight + w];
            const Place& place = places[weight.joint];
            expected += static_cast<double>(weight.bias) *
                        (place.position + place.turn * math::Vec3d(weight.position));
          }
          const math::Vec3 found = posed.meshes[number].positions[frame * mesh.vertices.size() + i];
          ASSERT_LT(glm::distance(math::Vec3d(found), expected), 1e-3)
              << "frame " << frame << ", vertex " << i;
        }
      }
    }
  }
}

// A sphere's normals point away from its center, on both sides of the seam too.
TEST(PosedModel, NormalsOfASphereAreItsRadii) {
  const Mdl mdl = test::sphere_mdl(20, 11);
  const test::Md5Sample sample = test::convert_to_md5(mdl, "skin");
  const PosedModel posed =
      pose_md5(read_md5_model(sample.mesh).value(), read_md5_animation(sample.animation).value()).value();
  const PosedMesh& mesh = posed.meshes[0];
  for (std::size_t i = 0; i < mesh.texels.size(); ++i) {
    const math::Vec3 radius = glm::normalize(mesh.positions[i]);
    // Normals are at least 14 degrees apart; the sphere is made of flat triangles.
    EXPECT_GT(glm::dot(mdl_normals()[mesh.normals[i]], radius),
              std::cos(16 * std::numbers::pi_v<float> / 180))
        << i;
  }
}

TEST(PosedModel, NormalsOfMd3FilesAreTheirAngles) {
  Md3 md3 = test::convert_to_md3(test::box_mdl(), "skin");
  for (unsigned zenith = 0; zenith < 256; zenith += 5)
    for (unsigned azimuth = 0; azimuth < 256; azimuth += 3) {
      md3.surfaces[0].vertices[0].zenith = static_cast<std::uint8_t>(zenith);
      md3.surfaces[0].vertices[0].azimuth = static_cast<std::uint8_t>(azimuth);
      const double from_z = zenith * std::numbers::pi / 128, around = azimuth * std::numbers::pi / 128;
      const math::Vec3d normal{std::sin(from_z) * std::cos(around), std::sin(from_z) * std::sin(around),
                               std::cos(from_z)};
      const PosedModel posed = pose_md3(md3).value();
      const math::Vec3d found(mdl_normals()[posed.meshes[0].normals[0]]);
      const math::Vec3d best(mdl_normals()[test::nearest_normal(normal)]);
      ASSERT_NEAR(glm::dot(found, normal), glm::dot(best, normal), 1e-6);
    }
}

TEST(PosedModel, TakesTheFramesOfItsMdlFile) {
  const Mdl mdl = test::small_mdl();  // a single frame, and a group of three
  const test::Md5Sample sample = test::bending_column(4, 3, 4, "skin");
  PosedModel posed =
      pose_md5(read_md5_model(sample.mesh).value(), read_md5_animation(sample.animation).value()).value();
  EXPECT_EQ(posed.frames.size(), 4u);
  take_frames(mdl, posed);
  ASSERT_EQ(posed.frames.size(), 2u);
  EXPECT_EQ(posed.frames[0].first_pose, 0u);
  EXPECT_EQ(posed.frames[1].first_pose, 1u);
  EXPECT_EQ(posed.frames[1].count, 3u);
  EXPECT_EQ(posed.frames[1].end_times_s, mdl.frames[1].end_times_s);
  EXPECT_EQ(posed.flags, mdl.flags);
}

TEST(PosedModel, FramesWithoutPosesShowTheLast) {
  const test::Md5Sample sample = test::bending_column(4, 3, 2, "skin");
  PosedModel posed =
      pose_md5(read_md5_model(sample.mesh).value(), read_md5_animation(sample.animation).value()).value();
  take_frames(test::many_pose_mdl(4), posed);  // four single frames and a group of four
  ASSERT_EQ(posed.frames.size(), 5u);
  for (const std::size_t frame : {1u, 2u, 3u, 4u}) {
    EXPECT_EQ(posed.frames[frame].first_pose, 1u);
    EXPECT_EQ(posed.frames[frame].count, 1u);
  }
}

TEST(PosedModel, RefusesWhatCannotBeStored) {
  const test::Md5Sample sample = test::bending_column(4, 3, 2, "skin");
  Md5Model model = read_md5_model(sample.mesh).value();
  Md5Animation animation = read_md5_animation(sample.animation).value();
  model.meshes[0].weights[0].bias = kMaxMd5Number;
  EXPECT_NE(pose_md5(model, animation).error().what.find("units away"), std::string::npos);
  model.meshes[0].vertices.clear();
  EXPECT_NE(pose_md5(model, animation).error().what.find("no vertices"), std::string::npos);
  model.meshes[0].vertices.resize(kMaxMd5Vertices);
  animation.poses.resize(kMaxMd5Frames, animation.poses[0]);
  EXPECT_NE(pose_md5(model, animation).error().what.find("too many"), std::string::npos);
  animation.joints.pop_back();
  EXPECT_FALSE(pose_md5(model, animation).ok());
}

}  // namespace
}  // namespace temblor::formats
