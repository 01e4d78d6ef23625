#include "compiler/bsp/brush_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/text.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// The interval that something covers on an axis.
struct Extent {
  double low = 1e30, high = -1e30;
};

Extent along(const Solid& solid, const Vec3d& axis) {
  Extent extent;
  for (const Vec3d& corner : solid.corners) {
    extent.low = std::min(extent.low, glm::dot(axis, corner));
    extent.high = std::max(extent.high, glm::dot(axis, corner));
  }
  return extent;
}

Extent along(const HullBox& box, const Vec3d& at, const Vec3d& axis) {
  Extent extent;
  extent.low = extent.high = glm::dot(axis, at);
  for (int i = 0; i < 3; ++i) {
    extent.low += std::min(axis[i] * box.mins[i], axis[i] * box.maxs[i]);
    extent.high += std::max(axis[i] * box.mins[i], axis[i] * box.maxs[i]);
  }
  return extent;
}

// The brush's texture decides whether it stops boxes.
bool stops_boxes(const formats::MapBrush& brush) {
  return std::none_of(brush.sides.begin(), brush.sides.end(), [](const formats::MapSide& side) {
    return side.texture.starts_with("*") || base::to_lower(side.texture) == "origin" ||
           base::to_lower(side.texture).starts_with("hint");
  });
}

}  // namespace

// Every three planes meet in a point; the points behind all planes are the corners.
Solid make_brush_solid(const formats::MapBrush& brush) {
  Solid solid;
  for (const formats::MapSide& side : brush.sides) {
    const auto& p = side.points_world;
    const Vec3d normal = glm::normalize(glm::cross(p[0] - p[1], p[2] - p[1]));
    solid.normals.push_back(normal);
    solid.distances.push_back(glm::dot(normal, p[1]));
  }
  const std::size_t sides = solid.normals.size();
  std::vector<std::array<std::size_t, 3>> vertex_planes;
  for (std::size_t i = 0; i < sides; ++i)
    for (std::size_t j = i + 1; j < sides; ++j)
      for (std::size_t k = j + 1; k < sides; ++k) {
        const Vec3d &a = solid.normals[i], &b = solid.normals[j], &c = solid.normals[k];
        const double volume = glm::dot(a, glm::cross(b, c));
        if (std::abs(volume) < 1e-6) continue;
        const Vec3d point = (glm::cross(b, c) * solid.distances[i] + glm::cross(c, a) * solid.distances[j] +
                             glm::cross(a, b) * solid.distances[k]) /
                            volume;
        bool inside = true;
        for (std::size_t s = 0; s < sides && inside; ++s)
          inside = glm::dot(solid.normals[s], point) <= solid.distances[s] + 0.01;
        if (!inside) continue;
        solid.corners.push_back(point);
        solid.mins = glm::min(solid.mins, point);
        solid.maxs = glm::max(solid.maxs, point);
      }
  for (std::size_t i = 0; i < sides; ++i)
    for (std::size_t j = i + 1; j < sides; ++j) {
      const Vec3d edge = glm::cross(solid.normals[i], solid.normals[j]);
      if (glm::length(edge) > 1e-6) solid.edges.push_back(glm::normalize(edge));
    }
  return solid;
}

std::vector<Vec3d> separating_axes(const Solid& solid) {
  std::vector<Vec3d> axes = solid.normals;
  for (int i = 0; i < 3; ++i) {
    Vec3d axis(0.0);
    axis[i] = 1;
    axes.push_back(axis);
    for (const Vec3d& edge : solid.edges)
      if (const Vec3d across = glm::cross(edge, axis); glm::length(across) > 1e-3)
        axes.push_back(glm::normalize(across));
  }
  return axes;
}

double depth_in(const Solid& solid, const HullBox& box, const Vec3d& at) {
  double least = std::numeric_limits<double>::max();
  for (const Vec3d& axis : separating_axes(solid)) {
    const Extent of_solid = along(solid, axis), of_box = along(box, at, axis);
    least = std::min({least, of_solid.high - of_box.low, of_box.high - of_solid.low});
  }
  return least;
}

double time_of_contact(const Solid& solid, const HullBox& box, const Vec3d& start, const Vec3d& end,
                       double gap) {
  constexpr double kNever = 2;
  double enter = 0, leave = 1;
  for (const Vec3d& axis : separating_axes(solid)) {
    const Extent of_solid = along(solid, axis), of_box = along(box, start, axis);
    const double speed = glm::dot(axis, end - start);
    // How far the box must move along the axis to come this near, and to be past again.
    const double until = of_solid.low - gap - of_box.high, past = of_solid.high + gap - of_box.low;
    if (std::abs(speed) < 1e-12) {
      if (until > 0 || past < 0) return kNever;
      continue;
    }
    enter = std::max(enter, std::min(until / speed, past / speed));
    leave = std::min(leave, std::max(until / speed, past / speed));
    if (enter > leave) return kNever;
  }
  return enter;
}

std::vector<Solid> solids_of_world(const formats::Map& map) {
  std::vector<Solid> solids;
  for (const formats::MapEntity& entity : map.entities) {
    const std::string_view name = entity.fields.classname();
    if (name != "worldspawn" && name != "func_group" && name != "func_detail" && name != "func_detail_wall" &&
        name != "func_detail_fence")
      continue;
    for (const formats::MapBrush& brush : entity.brushes)
      if (stops_boxes(brush)) {
        solids.push_back(make_brush_solid(brush));
        const std::string texture = base::to_lower(brush.sides.front().texture);
        solids.back().stops_points = texture != "clip" && !texture.starts_with("sky");
      }
  }
  return solids;
}

}  // namespace temblor::test
