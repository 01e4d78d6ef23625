#include "support/pictures/seen_area.h"

#include "world/visibility.h"

namespace temblor::test {

std::vector<double> compute_face_areas(const world::Level& level) {
  std::vector<double> areas;
  for (const world::Face& face : level.faces) {
    const auto corner = [&](std::uint32_t i) {
      return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    };
    math::Vec3d twice_area{0.0};
    for (std::uint32_t i = 2; i < face.surfedge_count; ++i)
      twice_area += glm::cross(corner(i - 1) - corner(0), corner(i) - corner(0));
    areas.push_back(glm::length(twice_area) / 2);
  }
  return areas;
}

double visible_area(const world::Level& level, world::LeafIndex from, const std::vector<double>& areas) {
  std::vector<std::uint8_t> row;
  world::decompress_pvs(level, from, row);
  std::vector<bool> counted(areas.size(), false);
  double sum = 0;
  for (std::size_t i = 1; i < level.leaves.size(); ++i) {
    if (!world::is_in_pvs(row, base::to_index<world::LeafIndex>(i))) continue;
    const world::Leaf& leaf = level.leaves[i];
    for (std::uint32_t k = 0; k < leaf.marked_face_count; ++k) {
      const std::size_t face = base::to_size(level.marked_faces[leaf.first_marked_face + k]);
      if (!counted[face]) sum += areas[face];
      counted[face] = true;
    }
  }
  return sum;
}

}  // namespace temblor::test
