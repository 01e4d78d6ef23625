#include "compiler/portal_file.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace temblor::compiler {
namespace {

using math::Vec3d;

// Newell's method: exact for any convex polygon, and robust if some corners are close together. Points
// clockwise seen from the front have a normal towards the viewer.
std::optional<Vec3d> find_normal(const std::vector<Vec3d>& points) {
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += glm::cross(points[(i + 1) % points.size()] - points[0], points[i] - points[0]);
  constexpr double kMinArea = 1e-6;  // units^2, doubled
  const double length = glm::length(sum);
  return std::isfinite(length) && length > kMinArea ? std::optional(sum / length) : std::nullopt;
}

Vec3d find_center(const std::vector<Vec3d>& points) {
  return std::accumulate(points.begin(), points.end(), Vec3d(0.0)) / static_cast<double>(points.size());
}

std::uint32_t find_cluster(const PortalSet& set, const formats::Bsp& bsp, const Vec3d& point_world) {
  std::int32_t child = bsp.models.front().head_nodes[0];
  while (child >= 0) {
    const formats::BspNode& node = bsp.nodes[static_cast<std::size_t>(child)];
    const formats::BspPlane& plane = bsp.planes[node.plane];
    child = node.children[glm::dot(Vec3d(plane.normal), point_world) >= double{plane.distance} ? 0 : 1];
  }
  return set.cluster_of_leaf[static_cast<std::size_t>(-(child + 1))];
}

}  // namespace

formats::PortalFile make_portal_file(const PortalSet& portals, std::size_t visible_leaves) {
  formats::PortalFile file;
  file.cluster_count = portals.cluster_count;
  for (std::size_t leaf = 1; leaf <= visible_leaves; ++leaf) {
    const std::uint32_t cluster = portals.cluster_of_leaf[leaf];
    file.cluster_of_leaf.push_back(cluster == kNoCluster ? file.cluster_count++ : cluster);
  }
  for (const Portal& portal : portals.portals)
    file.portals.push_back({portal.winding_world, {portal.clusters[0], portal.clusters[1]}});
  return file;
}

base::Result<PortalSet> match_portal_file(const formats::PortalFile& file, const formats::Bsp& bsp) {
  const auto leaves = static_cast<std::size_t>(bsp.models.front().visible_leaves);
  if (file.cluster_of_leaf.size() != leaves || leaves >= bsp.leaves.size())
    return base::malformed("the portals are those of a level with {} leaves, this one has {}",
                           file.cluster_of_leaf.size(), leaves);
  PortalSet set;
  set.cluster_count = file.cluster_count;
  set.cluster_of_leaf.assign(bsp.leaves.size(), kNoCluster);
  std::copy(file.cluster_of_leaf.begin(), file.cluster_of_leaf.end(), set.cluster_of_leaf.begin() + 1);
  std::size_t matched = 0;
  for (const formats::PrtPortal& from : file.portals) {
    const std::optional<Vec3d> normal = find_normal(from.points_world);
    if (!normal || from.clusters[0] == from.clusters[1]) {
      ++matched;
      continue;
    }
    const Vec3d center = find_center(from.points_world);
    constexpr double kProbe = 0.05;  // units in front of the portal and behind it
    const std::uint32_t front = find_cluster(set, bsp, center + *normal * kProbe);
    const std::uint32_t back = find_cluster(set, bsp, center - *normal * kProbe);
    Portal portal{from.points_world, *normal, glm::dot(center, *normal), from.clusters};
    const bool is_turned = front == from.clusters[1] && back == from.clusters[0];
    if (is_turned) std::swap(portal.clusters[0], portal.clusters[1]);
    if (is_turned || (front == from.clusters[0] && back == from.clusters[1])) ++matched;
    set.portals.push_back(std::move(portal));
  }
  if (matched * 2 < file.portals.size())
    return base::malformed("only {} of {} portals lie between their leaves: they are those of another level",
                           matched, file.portals.size());
  return set;
}

}  // namespace temblor::compiler
