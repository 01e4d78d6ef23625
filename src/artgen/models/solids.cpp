#include "artgen/models/solids.h"

#include <algorithm>
#include <cmath>

namespace temblor::artgen {
namespace {

using math::Vec2d;
using math::Vec3d;

std::uint32_t last_index(std::size_t count) {
  return static_cast<std::uint32_t>(count - 1);
}

// Without bevels, a box has 8 points and 6 flat sides. With bevels, it has 24 points, 6 sides, 12 edges, and
// 8 corner triangles in one smoothing group.
class BoxBuilder {
 public:
  BoxBuilder(const BoxSurface& surface, std::uint32_t shape, Mesh& io_mesh)
      : surface_(surface), shape_(shape), mesh_(io_mesh) {}

  void build() {
    const std::size_t first_chart = mesh_.chart_shapes.size();
    mesh_.chart_shapes.insert(mesh_.chart_shapes.end(), 6, shape_);
    charts_ = static_cast<std::uint32_t>(first_chart);
    if (surface_.bevel > 0) ++mesh_.smooth_count;
    if (surface_.bevel <= 0) add_corners();
    for (std::uint32_t side = 0; side < 6; ++side) add_side(side);
    if (surface_.bevel > 0) add_bevels();
  }

 private:
  // Bits 0 to 2 of a corner's number select the upper end on x, y, and z. A beveled corner has three points,
  // each on the side that is perpendicular to `flat_axis`.
  Vec3d corner_position(std::uint32_t corner, std::size_t flat_axis) const {
    Vec3d position;
    const double bevel = surface_.bevel;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double half = 0.5 * surface_.size[static_cast<int>(axis)] -
                          (bevel > 0 && axis != flat_axis ? std::min(bevel, 0.45 * smallest()) : 0.0);
      position[static_cast<int>(axis)] = (corner >> axis & 1) != 0 ? half : -half;
    }
    const double up = position.z / surface_.size.z + 0.5;
    position.x *= 1 + (surface_.taper.x - 1) * up;
    position.y *= 1 + (surface_.taper.y - 1) * up;
    return position;
  }
  double smallest() const { return std::min({surface_.size.x, surface_.size.y, surface_.size.z}); }

  // Box coordinates are kept, because charts and outward directions need them.
  void add_point(const Vec3d& position) {
    mesh_.points.push_back({surface_.transform(position), surface_.bone, surface_.bone, 0});
    local_.push_back(position);
  }

  void add_corners() {
    first_ = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::uint32_t corner = 0; corner < 8; ++corner) add_point(corner_position(corner, 0));
  }

  // The index of a corner's point on the side of an axis. Beveled points are made when they are first needed.
  std::uint32_t find_point(std::uint32_t corner, std::size_t axis) {
    if (surface_.bevel <= 0) return corner;
    std::int32_t& known = beveled_[corner * 3 + axis];
    if (known < 0) {
      if (local_.empty()) first_ = static_cast<std::uint32_t>(mesh_.points.size());
      add_point(corner_position(corner, axis));
      known = static_cast<std::int32_t>(local_.size()) - 1;
    }
    return static_cast<std::uint32_t>(known);
  }

  // Charts are projections along the axis of a side.
  MeshCorner make_corner(std::uint32_t local, std::uint32_t side) const {
    const Vec3d& position = local_[local];
    const std::uint32_t axis = side / 2;
    MeshCorner made;
    made.point = first_ + local;
    made.position = axis == 0   ? Vec2d(position.y, position.z)
                    : axis == 1 ? Vec2d(position.x, position.z)
                                : Vec2d(position.x, position.y);
    made.along = position.z / surface_.size.z + 0.5;
    made.around_deg = std::atan2(position.y, position.x) * 180 / 3.14159265358979;
    return made;
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t side) {
    MeshTriangle triangle;
    // Outward is away from the center, because the box is convex.
    const Vec3d normal = glm::cross(local_[b] - local_[a], local_[c] - local_[a]);
    if (glm::dot(normal, local_[a] + local_[b] + local_[c]) < 0) std::swap(b, c);
    triangle.corners = {make_corner(a, side), make_corner(b, side), make_corner(c, side)};
    triangle.chart = charts_ + side;
    triangle.smooth = mesh_.smooth_count - 1;
    mesh_.triangles.push_back(triangle);
    mesh_.is_image.push_back(false);
  }

  void add_quad(const std::array<std::uint32_t, 4>& points, std::uint32_t side) {
    add_triangle(points[0], points[1], points[2], side);
    add_triangle(points[0], points[2], points[3], side);
  }

  // Sides are numbered -x, +x, -y, +y, -z, +z.
  void add_side(std::uint32_t side) {
    if (surface_.bevel <= 0) ++mesh_.smooth_count;
    const std::uint32_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::uint32_t base = side % 2 << axis;
    add_quad({find_point(base, axis), find_point(base | 1u << u, axis),
              find_point(base | 1u << u | 1u << v, axis), find_point(base | 1u << v, axis)},
             side);
  }

  void add_bevels() {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::uint32_t edge = 0; edge < 4; ++edge) {
        const std::uint32_t low = (edge & 1) << u | (edge >> 1) << v, high = low | 1u << axis;
        // An edge lies on the chart of the upper or lower side if it borders on one, else on a vertical side.
        const std::uint32_t seen = u == 2 ? v : v == 2 ? u : 0u;
        const std::uint32_t side = seen * 2 + (low >> seen & 1);
        add_quad({find_point(low, u), find_point(high, u), find_point(high, v), find_point(low, v)}, side);
      }
    }
    for (std::uint32_t corner = 0; corner < 8; ++corner)
      add_triangle(find_point(corner, 0), find_point(corner, 1), find_point(corner, 2), 4 + (corner >> 2));
  }

  const BoxSurface& surface_;
  std::uint32_t shape_;
  Mesh& mesh_;
  std::uint32_t charts_ = 0, first_ = 0;
  std::vector<Vec3d> local_;  // points in the box's space
  std::array<std::int32_t, 24> beveled_ = [] {
    std::array<std::int32_t, 24> none{};
    none.fill(-1);
    return none;
  }();
};

// The area vector of the polygon (Newell's method). Its direction defines the front.
Vec3d outline_normal(const std::vector<MeshPoint>& outline) {
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < outline.size(); ++i)
    sum += glm::cross(outline[i].rest, outline[(i + 1) % outline.size()].rest);
  return glm::length(sum) > 1e-9 ? glm::normalize(sum) : Vec3d(0, 0, 1);
}

// Twice the signed area of a triangle: above 0 for a left turn.
double turn_direction(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Triangulates a counter-clockwise outline by ear clipping: cuts off the first convex corner that contains no
// other one.
std::vector<std::array<std::size_t, 3>> fill_outline(const std::vector<Vec2d>& flat) {
  std::vector<std::size_t> left(flat.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<std::array<std::size_t, 3>> triangles;
  while (left.size() >= 3) {
    // If the outline intersects itself, there may be no ear; then any corner is cut off.
    std::size_t ear = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::size_t before = left[(i + left.size() - 1) % left.size()], at = left[i],
                        after = left[(i + 1) % left.size()];
      if (turn_direction(flat[before], flat[at], flat[after]) <= 0) continue;
      const bool empty = std::none_of(left.begin(), left.end(), [&](std::size_t other) {
        return other != before && other != at && other != after &&
               turn_direction(flat[before], flat[at], flat[other]) >= 0 &&
               turn_direction(flat[at], flat[after], flat[other]) >= 0 &&
               turn_direction(flat[after], flat[before], flat[other]) >= 0;
      });
      if (!empty) continue;
      ear = i;
      break;
    }
    triangles.push_back(
        {left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace

void add_box(const BoxSurface& surface, std::uint32_t shape, Mesh& io_mesh) {
  BoxBuilder(surface, shape, io_mesh).build();
}

void add_plate(const PlateSurface& surface, std::uint32_t shape, Mesh& io_mesh) {
  const std::vector<MeshPoint>& outline = surface.outline;
  const Vec3d normal = outline_normal(outline);
  const Vec3d hint = std::abs(normal.z) < 0.9 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
  const Vec3d across = glm::normalize(glm::cross(hint, normal)), up = glm::cross(normal, across);
  const auto count = static_cast<std::uint32_t>(outline.size());
  const auto first = static_cast<std::uint32_t>(io_mesh.points.size());
  std::vector<Vec2d> flat;
  for (const double side : {0.5, -0.5}) {
    for (MeshPoint point : outline) {
      if (side > 0) flat.emplace_back(glm::dot(point.rest, across), glm::dot(point.rest, up));
      point.rest += normal * (side * surface.thickness);
      io_mesh.points.push_back(point);
    }
  }
  const auto add = [&](const std::array<MeshCorner, 3>& corners) {
    io_mesh.triangles.push_back({corners, last_index(io_mesh.chart_shapes.size()), io_mesh.smooth_count - 1});
    io_mesh.is_image.push_back(false);
  };
  const std::vector<std::array<std::size_t, 3>> filling = fill_outline(flat);
  for (const bool front : {true, false}) {
    io_mesh.chart_shapes.push_back(shape);
    ++io_mesh.smooth_count;
    const auto corner = [&](std::size_t i) {
      return MeshCorner{first + static_cast<std::uint32_t>(i) + (front ? 0 : count), flat[i], 0.5, 0};
    };
    for (const auto& [a, b, c] : filling)
      add(front ? std::array{corner(a), corner(b), corner(c)} : std::array{corner(a), corner(c), corner(b)});
  }
  io_mesh.chart_shapes.push_back(shape);
  double length = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    ++io_mesh.smooth_count;
    const std::uint32_t next = (i + 1) % count;
    const double end = length + glm::distance(outline[i].rest, outline[next].rest);
    const MeshCorner a{first + i, {length, surface.thickness}, 0.5, 0},
        b{first + next, {end, surface.thickness}, 0.5, 0}, c{first + count + next, {end, 0}, 0.5, 0},
        d{first + count + i, {length, 0}, 0.5, 0};
    add({a, d, c});
    add({a, c, b});
    length = end;
  }
}

}  // namespace temblor::artgen
