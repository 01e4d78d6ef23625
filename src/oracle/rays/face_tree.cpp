#include "oracle/rays/face_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::oracle {
namespace {

constexpr std::uint32_t kPolygonsPerLeaf = 4;
constexpr double kBoxMargin = 0.01;  // vertices lie this near to their planes, and more, in real levels

int largest_axis(const math::Vec3d& v) {
  const math::Vec3d size = glm::abs(v);
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

// Even-odd rule: correct for concave polygons too, in either direction.
bool inside_polygon(std::span<const math::Vec3d> vertices, const math::Vec3d& point, int dropped_axis) {
  const int u = (dropped_axis + 1) % 3, v = (dropped_axis + 2) % 3;
  bool inside = false;
  math::Vec3d from = vertices.back();
  for (const math::Vec3d& to : vertices) {
    if ((from[v] > point[v]) != (to[v] > point[v])) {
      const double crossing_u = from[u] + (point[v] - from[v]) / (to[v] - from[v]) * (to[u] - from[u]);
      if (point[u] < crossing_u) inside = !inside;
    }
    from = to;
  }
  return inside;
}

// Whether the part of the ray in [min_distance, max_distance] meets the box.
bool meets_box(const Ray& ray, const math::Vec3d& mins, const math::Vec3d& maxs, double min_distance,
               double max_distance) {
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < mins[axis] || ray.origin[axis] > maxs[axis]) return false;
      continue;
    }
    const double a = (mins[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (maxs[axis] - ray.origin[axis]) / ray.direction[axis];
    min_distance = std::max(min_distance, std::min(a, b));
    max_distance = std::min(max_distance, std::max(a, b));
  }
  return min_distance <= max_distance;
}

}  // namespace

FaceTree::FaceTree(const world::Level& level, const world::Model& model) {
  for (std::uint32_t i = 0; i < model.face_count; ++i) {
    const auto index = static_cast<world::FaceIndex>(model.first_face + i);
    const world::Face& face = level.face(index);
    if (face.surfedge_count < 3) continue;
    const world::Plane& plane = level.planes[face.plane];
    const double side = face.back_side ? -1 : 1;
    Polygon polygon{.face = index,
                    .normal = math::Vec3d(plane.normal) * side,
                    .plane_distance = static_cast<double>(plane.distance) * side,
                    .dropped_axis = largest_axis(plane.normal),
                    .first_vertex = static_cast<std::uint32_t>(vertices_.size()),
                    .vertex_count = face.surfedge_count};
    for (std::uint32_t edge = 0; edge < face.surfedge_count; ++edge)
      vertices_.push_back(level.vertices[level.surfedge_start(face.first_surfedge + edge)]);
    polygons_.push_back(polygon);
  }
  if (!polygons_.empty()) build(0, static_cast<std::uint32_t>(polygons_.size()));
}

FaceTree::Box FaceTree::measure_bounds(const Polygon& polygon) const {
  Box box;
  for (const math::Vec3d& vertex : list_vertices(polygon)) {
    box.mins = glm::min(box.mins, vertex - kBoxMargin);
    box.maxs = glm::max(box.maxs, vertex + kBoxMargin);
  }
  return box;
}

// Splits the polygons at the median of their boxes' centers along the longest side, so the tree's depth is
// the logarithm of their number.
std::uint32_t FaceTree::build(std::uint32_t first, std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box box;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Box part = measure_bounds(polygons_[i]);
    box.mins = glm::min(box.mins, part.mins);
    box.maxs = glm::max(box.maxs, part.maxs);
  }
  Node node{.box = box, .first = first, .count = count};
  if (count > kPolygonsPerLeaf) {
    const int axis = largest_axis(box.maxs - box.mins);
    const auto begin = polygons_.begin() + first;
    const auto center = [&](const Polygon& polygon) {
      const Box part = measure_bounds(polygon);
      return part.mins[axis] + part.maxs[axis];
    };
    std::nth_element(begin, begin + count / 2, begin + count,
                     [&](const Polygon& a, const Polygon& b) { return center(a) < center(b); });
    node.count = 0;
    node.children[0] = build(first, count / 2);
    node.children[1] = build(first + count / 2, count - count / 2);
  }
  nodes_[index] = node;
  return index;
}

std::optional<double> FaceTree::meet(const Ray& ray, const Polygon& polygon) const {
  const double approach = glm::dot(ray.direction, polygon.normal);
  if (approach >= 0) return std::nullopt;
  const double distance = (polygon.plane_distance - glm::dot(ray.origin, polygon.normal)) / approach;
  if (!inside_polygon(list_vertices(polygon), ray.at(distance), polygon.dropped_axis)) return std::nullopt;
  return distance;
}

std::optional<FaceHit> FaceTree::nearest(const Ray& ray, double min_distance, Accept accept) const {
  std::optional<FaceHit> best;
  double limit = std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> pending;
  if (!nodes_.empty()) pending.push_back(0);
  while (!pending.empty()) {
    const Node& node = nodes_[pending.back()];
    pending.pop_back();
    if (!meets_box(ray, node.box.mins, node.box.maxs, min_distance, limit)) continue;
    if (node.count == 0) pending.insert(pending.end(), node.children, node.children + 2);
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::optional<double> distance = meet(ray, polygons_[i]);
      if (!distance || *distance < min_distance || *distance >= limit) continue;
      const FaceHit hit{polygons_[i].face, *distance};
      if (!accept(hit)) continue;
      best = hit;
      limit = *distance;
    }
  }
  return best;
}

std::optional<double> FaceTree::distance_to(const Ray& ray, world::FaceIndex face) const {
  for (const Polygon& polygon : polygons_)
    if (polygon.face == face) return meet(ray, polygon);
  return std::nullopt;
}

}  // namespace temblor::oracle
