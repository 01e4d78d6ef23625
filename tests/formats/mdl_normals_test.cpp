// The table against its definition (an icosahedron's symmetry), and against the normals of stock models.
#include "formats/mdl_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "formats/mdl.h"
#include "support/game_data.h"

namespace temblor::formats {
namespace {

double angle_deg(const math::Vec3d& a, const math::Vec3d& b) {
  return 2 * std::asin(std::min(glm::length(a - b) / 2, 1.0)) * 180 / std::numbers::pi;
}

// The index of the nearest normal.
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

// Mirrored in any axis plane, or with its axes exchanged in turn, an icosahedron stays the same.
TEST(MdlNormals, HaveAnIcosahedronsSymmetry) {
  for (const math::Vec3& normal : mdl_normals()) {
    for (const math::Vec3d& image :
         {math::Vec3d(-normal.x, normal.y, normal.z), math::Vec3d(normal.x, -normal.y, normal.z),
          math::Vec3d(normal.x, normal.y, -normal.z), math::Vec3d(normal.y, normal.z, normal.x)})
      EXPECT_LT(angle_deg(mdl_normals()[nearest(image)], image), 1e-3);
  }
}

// Adds, for every normal index, the area-weighted geometric normals of the vertices that have it.
void add_vertex_normals(const Mdl& mdl, const MdlPose& pose, std::array<math::Vec3d, kMdlNormals>& io_sums) {
  std::vector<math::Vec3d> normals(pose.vertices.size());
  const auto position = [&](std::uint32_t vertex) {
    const auto& [x, y, z] = pose.vertices[vertex].position;
    return math::Vec3d(mdl.scale) * math::Vec3d(x, y, z);
  };
  for (const auto& [faces_front, corners] : mdl.triangles) {
    const math::Vec3d a = position(corners[0]), b = position(corners[1]), c = position(corners[2]);
    const math::Vec3d outward = glm::cross(c - a, b - a);  // clockwise from outside
    for (const std::uint32_t vertex : corners) normals[vertex] += outward;
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (const double length = glm::length(normals[i]); length > 0)
      io_sums[pose.vertices[i].normal] += normals[i] / length;
}

TEST(MdlNormals, AreWhatStockModelsMean) {
  DATA_FOLDER_OR_SKIP(data);
  std::array<math::Vec3d, kMdlNormals> sums{};
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "progs")) {
    if (entry.path().extension() != ".mdl") continue;
    const Mdl mdl = read_mdl(test::read_file(entry.path())).value();
    // Some have a hundred times as many frames as others, whose vertices count as well.
    const std::size_t step = std::max<std::size_t>(1, mdl.frames.size() / 25);
    for (std::size_t i = 0; i < mdl.frames.size(); i += step)
      for (const MdlPose& pose : mdl.frames[i].poses) add_vertex_normals(mdl, pose, sums);
  }
  double sum_deg = 0;
  for (std::size_t i = 0; i < kMdlNormals; ++i) {
    ASSERT_GT(glm::length(sums[i]), 100) << "index " << i << " is too rare to tell";
    const math::Vec3d mean = glm::normalize(sums[i]);
    EXPECT_EQ(nearest(mean), i);
    sum_deg += angle_deg(mdl_normals()[i], mean);
  }
  EXPECT_LT(sum_deg / kMdlNormals, 3.5);
}

}  // namespace
}  // namespace temblor::formats
