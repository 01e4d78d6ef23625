#include "client/lines/world_text.h"

#include <gtest/gtest.h>

#include "math/angles.h"

namespace temblor::client {
namespace {

std::vector<render::Line> write(const std::string& text, const math::Vec3& angles = math::Vec3(0.0f)) {
  std::vector<render::Line> lines;
  append_text_lines({text, {10, 20, 30}, 8, true}, angles, lines);
  return lines;
}

TEST(WorldText, SpacesAndControlCharactersHaveNoStrokes) {
  EXPECT_TRUE(write("").empty());
  EXPECT_TRUE(write(" \n\x01").empty());
}

TEST(WorldText, SmallLettersAreCapitals) {
  const auto small = write("az"), capital = write("AZ");
  ASSERT_EQ(small.size(), capital.size());
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_EQ(small[i].from_world, capital[i].from_world);
}

TEST(WorldText, UnknownCharactersAreBoxes) {
  EXPECT_EQ(write("\x80").size(), 4u);
  EXPECT_EQ(write("~").size(), 4u);
}

// An "L" seen from the south-west: a stroke down and one to the right, which both face the camera.
TEST(WorldText, FacesTheCamera) {
  const math::Vec3 angles(20, 30, 0);
  const math::Basis axes = math::basis_from_angles(angles);
  const auto lines = write("L", angles);
  ASSERT_EQ(lines.size(), 2u);
  const auto expect_near = [](const math::Vec3& a, const math::Vec3& b) {
    EXPECT_LT(glm::distance(a, b), 1e-4f);
  };
  expect_near(lines[0].to_world - lines[0].from_world, math::Vec3(axes.up) * -8.0f);
  expect_near(lines[1].to_world - lines[1].from_world, math::Vec3(axes.right) * 4.0f);
  expect_near((lines[0].from_world + lines[1].to_world) / 2.0f, {10, 20, 30});
  EXPECT_TRUE(lines[0].is_depth_tested);
}

TEST(WorldText, LettersAreApart) {
  const auto one = write("I"), three = write("III");
  ASSERT_EQ(three.size(), 3 * one.size());
  EXPECT_EQ(three[one.size()].from_world, one[0].from_world) << "the middle letter is in the middle";
  EXPECT_FLOAT_EQ(glm::distance(three[0].from_world, one[0].from_world), 6);
}

}  // namespace
}  // namespace temblor::client
