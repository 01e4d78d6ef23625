// Compares the table with its definition (the symmetry of an icosahedron), and with the normals of stock
// models.
#include "formats/models/mdl_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "formats/models/mdl.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

double angle_deg(const math::Vec3d& a, const math::Vec3d& b) {
  return 2 * std::asin(std::min(glm::length(a - b) / 2, 1.0)) * 180 / std::numbers::pi;
}

// Returns the index of the nearest normal.
std::size_t nearest(const math::Vec3d& direction) {
  const auto normals = mdl_normals();
  return static_cast<std::size_t>(
      std::ranges::max_element(
          normals, {}, [&](const math::Vec3& normal) { return glm::dot(math::Vec3d(normal), direction); }) -
      normals.begin());
}

TEST(MdlNormals, AreUnitVectorsFarApart) {
  const auto normals = mdl_normals();
  ASSERT_EQ(normals.size(), kMdlNormals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_NEAR(glm::length(math::Vec3d(normals[i])), 1, 1e-7) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(angle_deg(normals[i], normals[j]), 14) << i << ", " << j;
  }
}

// An icosahedron is symmetric: mirrored in any axis plane, or with its axes rotated, it stays the same.
TEST(MdlNormals, HaveAnIcosahedronsSymmetry) {
  for (const math::Vec3& normal : mdl_normals()) {
    for (const math::Vec3d& image :
         {math::Vec3d(-normal.x, normal.y, normal.z), math::Vec3d(normal.x, -normal.y, normal.z),
          math::Vec3d(normal.x, normal.y, -normal.z), math::Vec3d(normal.y, normal.z, normal.x)})
      EXPECT_LT(angle_deg(mdl_normals()[nearest(image)], image), 1e-3);
  }
}

TEST(MdlNormals, TheNearestIsThatOfAllComparisons) {
  test::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    math::Vec3 direction = random.in_cube(100);
    // Some on the borders of octants.
    if (random.chance(0.2)) direction[static_cast<int>(random.below(3))] = random.chance(0.5) ? 0.0f : -0.0f;
    const math::Vec3 found = mdl_normals()[find_nearest_normal(direction)];
    const math::Vec3 best = mdl_normals()[nearest(math::Vec3d(direction))];
    ASSERT_NEAR(glm::dot(found, direction), glm::dot(best, direction), 1e-4);
  }
  EXPECT_LT(find_nearest_normal(math::Vec3(0.0f)), kMdlNormals);
}

math::Vec3d position(const Mdl& mdl, const MdlVertex& vertex) {
  const auto& [x, y, z] = vertex.position;
  return math::Vec3d(mdl.scale) * math::Vec3d(x, y, z);
}

// The mean direction of the vertices with each normal index. A vertex counts only if two methods give the
// same normal: the area-weighted mean of its own triangles, as in some exporters, and the plain mean of the
// triangles of all vertices at its position (models split vertices at the seam of the skin), as in others.
class MeanNormals {
 public:
  void add(const Mdl& mdl, const MdlPose& pose) {
    std::vector<math::Vec3d> by_area(pose.vertices.size());
    std::map<std::array<std::uint8_t, 3>, math::Vec3d> by_place;
    for (const MdlTriangle& triangle : mdl.triangles) {
      std::array<math::Vec3d, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = position(mdl, pose.vertices[triangle.vertices[i]]);
      // Corners are clockwise as seen from outside.
      const math::Vec3d outward = glm::cross(corners[2] - corners[0], corners[1] - corners[0]);
      if (glm::length(outward) == 0) continue;
      for (const std::uint32_t vertex : triangle.vertices) {
        by_area[vertex] += outward;
        by_place[pose.vertices[vertex].position] += glm::normalize(outward);
      }
    }
    for (std::size_t i = 0; i < by_area.size(); ++i)
      add_if_same(by_area[i], by_place[pose.vertices[i].position], pose.vertices[i].normal);
  }

  int count(std::size_t index) const { return counts_[index]; }
  math::Vec3d mean(std::size_t index) const { return glm::normalize(sums_[index]); }

 private:
  void add_if_same(const math::Vec3d& a, const math::Vec3d& b, std::uint8_t index) {
    constexpr double kSame_deg = 10;
    if (glm::length(a) == 0 || glm::length(b) == 0) return;
    if (angle_deg(glm::normalize(a), glm::normalize(b)) > kSame_deg) return;
    sums_[index] += glm::normalize(a);
    ++counts_[index];
  }

  std::array<math::Vec3d, kMdlNormals> sums_{};
  std::array<int, kMdlNormals> counts_{};
};

// Creatures are smooth everywhere, so their vertices have meaningful normals. (Not the knight: its normals
// match no geometry.)
TEST(MdlNormals, MatchStockModels) {
  DATA_FOLDER_OR_SKIP(data);
  MeanNormals normals;
  for (const char* name : {"boss", "demon", "dog", "enforcer", "fish", "hknight", "ogre", "oldone", "player",
                           "shalrath", "shambler", "soldier", "tarbaby", "wizard", "zombie"}) {
    const Mdl mdl = read_mdl(test::read_file(data / "id1" / "progs" / (std::string(name) + ".mdl"))).value();
    constexpr std::size_t kFrameStep = 4;  // neighbors are alike
    for (std::size_t i = 0; i < mdl.frames.size(); i += kFrameStep)
      normals.add(mdl, mdl.frames[i].poses.front());
  }
  double sum_deg = 0;
  for (std::size_t i = 0; i < kMdlNormals; ++i) {
    ASSERT_GT(normals.count(i), 50) << "index " << i << " is too rare to tell";
    EXPECT_EQ(nearest(normals.mean(i)), i);
    const double off_deg = angle_deg(mdl_normals()[i], normals.mean(i));
    EXPECT_LT(off_deg, 6.5) << i;
    sum_deg += off_deg;
  }
  EXPECT_LT(sum_deg / kMdlNormals, 2);
}

}  // namespace
}  // namespace temblor::formats
