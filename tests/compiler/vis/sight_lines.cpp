#include "compiler/vis/sight_lines.h"

#include "support/game_data.h"

namespace temblor::compiler {

namespace {

double above(const formats::BspPlane& plane, const math::Vec3d& point) {
  return glm::dot(math::Vec3d(plane.normal), point) - double{plane.distance};
}

void walk(const formats::Bsp& bsp, std::int32_t child, const math::Vec3d& start, const math::Vec3d& end,
          std::vector<LeafCrossing>& out_crossings) {
  if (child < 0) {
    out_crossings.push_back({static_cast<std::size_t>(-(child + 1)), start});
    return;
  }
  const formats::BspNode& node = bsp.nodes[static_cast<std::size_t>(child)];
  const formats::BspPlane& plane = bsp.planes[node.plane];
  const double start_above = above(plane, start), end_above = above(plane, end);
  const std::size_t first = start_above >= 0 ? 0 : 1;
  if ((start_above >= 0) == (end_above >= 0)) {
    walk(bsp, node.children[first], start, end, out_crossings);
    return;
  }
  const math::Vec3d middle = start + (end - start) * (start_above / (start_above - end_above));
  walk(bsp, node.children[first], start, middle, out_crossings);
  walk(bsp, node.children[1 - first], middle, end, out_crossings);
}

}  // namespace

formats::Bsp finished_level(const std::filesystem::path& base_folder, const std::string& name) {
  const auto bytes = test::read_file(base_folder / "id1" / "maps" / (name + ".bsp"));
  return std::move(formats::read_bsp(bytes)).value();
}

std::vector<LeafCrossing> leaves_along(const formats::Bsp& bsp, const math::Vec3d& start,
                                       const math::Vec3d& end) {
  std::vector<LeafCrossing> crossings;
  walk(bsp, bsp.models[0].head_nodes[0], start, end, crossings);
  return crossings;
}

std::size_t leaf_at(const formats::Bsp& bsp, const math::Vec3d& point) {
  return leaves_along(bsp, point, point)[0].leaf;
}

math::Vec3d random_point(const formats::Bsp& bsp, test::Random& random) {
  math::Vec3d point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = random.uniform(double{bsp.models[0].mins[axis]}, double{bsp.models[0].maxs[axis]});
  return point;
}

std::optional<math::Vec3d> random_open_point(const formats::Bsp& bsp, test::Random& random) {
  constexpr std::int32_t kSolid = -2, kSky = -6;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const math::Vec3d point = random_point(bsp, random);
    const std::int32_t contents = bsp.leaves[leaf_at(bsp, point)].contents;
    if (contents != kSolid && contents != kSky) return point;
  }
  return std::nullopt;
}

}  // namespace temblor::compiler
