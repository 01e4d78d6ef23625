#include "client/lines/box_lines.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace temblor::client {
namespace {

std::vector<render::Line> make_lines(const math::Bounds& box) {
  std::vector<render::Line> lines;
  make_box_lines({&box, 1}, lines);
  return lines;
}

TEST(BoxLines, AreTheTwelveEdges) {
  const math::Bounds box{math::Vec3(-1, -2, -3), math::Vec3(4, 5, 6)};
  std::set<std::tuple<float, float, float, float, float, float>> seen;
  for (const render::Line& line : make_lines(box)) {
    const math::Vec3 size = line.to_world - line.from_world;
    int moves = 0;
    for (int axis = 0; axis < 3; ++axis) {
      moves += size[axis] != 0;
      for (const float at : {line.from_world[axis], line.to_world[axis]})
        EXPECT_TRUE(at == box.mins[axis] || at == box.maxs[axis]);
    }
    EXPECT_EQ(moves, 1) << "along one axis";
    seen.insert({line.from_world.x, line.from_world.y, line.from_world.z, line.to_world.x, line.to_world.y,
                 line.to_world.z});
  }
  EXPECT_EQ(seen.size(), 12u);
}

TEST(BoxLines, OfAPointAreACross) {
  const math::Vec3 at(10, 20, 30);
  const std::vector<render::Line> lines = make_lines({at, at});
  ASSERT_EQ(lines.size(), 3u);
  for (const render::Line& line : lines) {
    EXPECT_EQ((line.from_world + line.to_world) * 0.5f, at);
    EXPECT_EQ(glm::distance(line.from_world, line.to_world), 16);
  }
}

}  // namespace
}  // namespace temblor::client
