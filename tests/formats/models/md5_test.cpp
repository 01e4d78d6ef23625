#include "formats/models/md5.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/game_data.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

// An arm along x, whose hand is turned to the left (+y), and an animation that turns it to the right as well.
std::string seed(const char* name) {
  const base::ByteVector bytes =
      test::read_file(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "fuzz/corpus/md5" / name);
  return std::string(base::as_text(bytes));
}
std::string replaced(std::string text, std::string_view old, std::string_view by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

void expect_near(math::Vec3 actual, math::Vec3 expected) {
  EXPECT_LT(glm::distance(actual, expected), 1e-5f) << actual.x << " " << actual.y << " " << actual.z;
}

TEST(Md5, ReadsAModel) {
  const auto model = read_md5_model(seed("arm.md5mesh"));
  ASSERT_TRUE(model.ok()) << model.error().message();
  const std::vector<Md5Joint> joints = {{"root", -1}, {"hand", 0}};
  EXPECT_EQ(model->joints, joints);
  ASSERT_EQ(model->meshes.size(), 1u);
  const Md5Mesh& mesh = model->meshes[0];
  EXPECT_EQ(mesh.shader, "progs/arm");
  EXPECT_EQ(mesh.vertices[2].texel, math::Vec2(0.5f, 1.0f));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(Md5, SkinsVerticesByTheirWeights) {
  const Md5Model model = read_md5_model(seed("arm.md5mesh")).value();
  const std::vector<math::Vec3> bound = skin_vertices(model.meshes[0], model.bind_pose);
  ASSERT_EQ(bound.size(), 3u);
  expect_near(bound[0], {0, 0, 0});
  expect_near(bound[1], {4, 2, 0});  // a quarter turn to the left, although w is negative
  expect_near(bound[2], {3, 0, 2});  // the mean of (2, 0, 1) and (4, 0, 3)
  const Md5Animation animation = read_md5_animation(seed("arm.md5anim")).value();
  ASSERT_TRUE(check_same_skeleton(model, animation).ok());
  EXPECT_EQ(animation.frames_per_second, 10);
  ASSERT_EQ(animation.poses.size(), 2u);
  expect_near(skin_vertices(model.meshes[0], animation.poses[0])[1], {4, 2, 1});
  expect_near(skin_vertices(model.meshes[0], animation.poses[1])[1], {5, -2, 1});
}

// A chain of joints, each of which is turned by a random angle about z. Its ends are computed by adding the
// angles.
TEST(Md5, JointsTurnWithTheirParents) {
  test::Random random(5);
  for (int run = 0; run < 50; ++run) {
    const std::size_t count = 1 + random.below(20);
    std::string hierarchy, base;
    double angle = 0, x = 0, y = 0;
    for (std::size_t joint = 0; joint < count; ++joint) {
      const double length = 1 + static_cast<double>(random.below(100)) / 10;
      const double turn = static_cast<double>(random.below(3142)) / 1000 - 1.571;
      x += std::cos(angle) * length;
      y += std::sin(angle) * length;
      angle += turn;
      hierarchy += fmt::format("\"{}\" {} 0 0\n", joint, static_cast<int>(joint) - 1);
      base += fmt::format("( {} 0 0 ) ( 0 0 {} )\n", length, -std::sin(turn / 2));
    }
    const std::string text = fmt::format(
        "MD5Version 10 numFrames 1 numJoints {} frameRate 1 numAnimatedComponents 0 hierarchy {{ {} }} "
        "baseframe {{ {} }} frame 0 {{ }}",
        count, hierarchy, base);
    const auto animation = read_md5_animation(text);
    ASSERT_TRUE(animation.ok()) << animation.error().message();
    const Md5JointPose& end = animation->poses[0].back();
    EXPECT_NEAR(end.position.x, x, 0.001);
    EXPECT_NEAR(end.position.y, y, 0.001);
    const math::Vec3 ahead = end.orientation * math::Vec3(1, 0, 0);
    EXPECT_NEAR(ahead.x, std::cos(angle), 0.001);
    EXPECT_NEAR(ahead.y, std::sin(angle), 0.001);
  }
}

TEST(Md5, ErrorsNameTheLine) {
  const std::string mesh = seed("arm.md5mesh"), animation = seed("arm.md5anim");
  const auto model_error = [&](std::string_view old, std::string_view by) {
    const auto model = read_md5_model(replaced(mesh, old, by));
    return model.ok() ? "none" : model.error().what;
  };
  EXPECT_EQ(model_error("MD5Version 10", "MD5Version 6"), "line 1: \"6\" instead of 10");
  EXPECT_EQ(model_error("\"hand\"\t0", "\"hand\"\t1"),
            "line 9: the parent of joint 1 is joint 1, not an earlier one or -1");
  EXPECT_EQ(model_error("numverts 3", "numverts 2"), "line 18: \"vert\" instead of \"numtris\"");
  EXPECT_EQ(model_error("numverts 3", "numverts 70000"),
            "line 15: \"70000\" is not a whole number from 0 to 65536");
  EXPECT_EQ(model_error("vert 1", "vert 2"), "line 17: vert \"2\" instead of 1");
  EXPECT_EQ(model_error("tri 0 0 1 2", "tri 0 0 1 3"), "line 21: \"3\" is not a whole number from 0 to 2");
  EXPECT_EQ(model_error("weight 3 1", "weight 3 2"), "line 27: \"2\" is not a whole number from 0 to 1");
  EXPECT_EQ(model_error("0.5 ( 0 0 3 )", "nan ( 0 0 3 )"), "line 27: \"nan\" is not a number within 1048576");
  EXPECT_THAT(model_error("2 2\n", "2 3\n"), HasSubstr("vertex 2 has weights 2 to 5, but the mesh has 4"));
  EXPECT_THAT(model_error(") 0 1\n", ") 0 2\n"), HasSubstr("the vertices have 5 weights together"));
  EXPECT_EQ(model_error("\"test\"", "\"test"), "line 2: this quote is never closed");
  EXPECT_EQ(read_md5_model("").error().what, "line 1: the file ends too early");
  const auto animation_error = [&](std::string_view old, std::string_view by) {
    const auto read = read_md5_animation(replaced(animation, old, by));
    return read.ok() ? "none" : read.error().what;
  };
  EXPECT_EQ(animation_error("0 33 0", "0 63 0"), "line 11: joint 1 has components 0 to 6, but frames have 2");
  EXPECT_EQ(animation_error("4 -0.7071068", "4"), "line 26: \"}\" is not a number within 1048576");
  EXPECT_EQ(animation_error("frame 1 {", "frame 7 {"), "line 28: frame \"7\" instead of 1");
  EXPECT_EQ(animation_error("numFrames 2\nnumJoints 2", "numFrames 16384\nnumJoints 1000"),
            "line 5: 16384 frames of 1000 joints are too many");
}

TEST(Md5, AnAnimationFitsOneSkeleton) {
  const Md5Model model = read_md5_model(seed("arm.md5mesh")).value();
  Md5Animation animation = read_md5_animation(seed("arm.md5anim")).value();
  animation.joints[1].name = "foot";
  EXPECT_EQ(check_same_skeleton(model, animation).error().what,
            "joint 1 is \"foot\" below joint 0 in the animation, but \"hand\" below joint 0 in the model");
  animation.joints.pop_back();
  EXPECT_EQ(check_same_skeleton(model, animation).error().what,
            "the animation has 1 joint, but the model has 2");
}

TEST(Md5, TruncatedFilesAreErrors) {
  for (const std::string& text : {seed("arm.md5mesh"), seed("arm.md5anim")}) {
    const std::size_t last_brace = text.rfind('}');
    for (std::size_t size = 0; size <= last_brace; ++size) {
      EXPECT_FALSE(read_md5_model(text.substr(0, size)).ok()) << size;
      EXPECT_FALSE(read_md5_animation(text.substr(0, size)).ok()) << size;
    }
  }
}

}  // namespace
}  // namespace temblor::formats
