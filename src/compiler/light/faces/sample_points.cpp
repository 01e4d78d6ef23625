#include "compiler/light/faces/sample_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "world/face_at.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

constexpr double kLift = 1;      // in front of the plane, so that surfaces in the plane cast no shadow on it
constexpr double kMargin = 0.5;  // inside the face, so that a wall on its edge does not touch the sample
constexpr float kKeepAway = 1;   // from a wall between the face and a sample
constexpr double kMinVolume = 1e-6;

// The point of the face nearest to `point` that keeps kMargin from the face's edges, as far as the face is
// that wide.
math::Vec3d move_inside_face(const LightGrid& grid, const math::Vec3d& point) {
  const std::vector<math::Vec3d>& corners = grid.corners_world;
  bool inside = true;
  double nearest_squared = std::numeric_limits<double>::infinity();
  math::Vec3d nearest = point;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const math::Vec3d start = corners[i], way = corners[(i + 1) % corners.size()] - start;
    const double length_squared = glm::dot(way, way);
    if (!(length_squared > 0)) continue;
    // Corners run clockwise, so the inside is to the right of every side.
    const double outside = glm::dot(glm::cross(way, point - start), grid.normal) / std::sqrt(length_squared);
    inside = inside && outside <= -kMargin;
    const math::Vec3d candidate =
        start + way * std::clamp(glm::dot(point - start, way) / length_squared, 0.0, 1.0);
    const math::Vec3d away = point - candidate;
    if (const double squared = glm::dot(away, away); squared < nearest_squared) {
      nearest_squared = squared;
      nearest = candidate;
    }
  }
  if (inside) return point;
  const math::Vec3d inward = grid.middle_world - nearest;
  const double length = glm::length(inward);
  return length > 0 ? nearest + inward * std::min(1.0, 2 * kMargin / length) : nearest;
}

// A place, and the leaf that it is in; leaf 0: it is solid.
struct OpenPlace {
  math::Vec3d place{0.0};
  world::LeafIndex leaf{0};
};

// Finds out which leaf a place is in.
OpenPlace look_at(const world::Level& level, const math::Vec3d& place) {
  const world::LeafIndex leaf = world::find_leaf(level, math::Vec3(place));
  const bool solid = level.leaf(leaf).contents == world::Contents::kSolid;
  return {place, solid ? world::LeafIndex{0} : leaf};
}

bool is_open(const OpenPlace& place) {
  return place.leaf != world::LeafIndex{0};
}

// Moves `place` toward the center of the face until it is in open space; returns `place` itself if it never
// is.
OpenPlace move_into_open(const world::Level& level, const math::Vec3d& place, const math::Vec3d& middle) {
  constexpr std::array<double, 6> kTries{0.0, 0.02, 0.1, 0.25, 0.5, 1.0};
  for (const double share : kTries)
    if (const OpenPlace moved = look_at(level, place + (middle - place) * share); is_open(moved))
      return moved;
  return {place, world::LeafIndex{0}};
}

// Goes from `start` toward `end` until something is in the way.
math::Vec3d find_farthest_open(const RayScene& scene, const math::Vec3d& start, const math::Vec3d& end) {
  const auto length = static_cast<float>(glm::length(end - start));
  if (length <= 0) return end;
  const math::Vec3 from(start), direction((end - start) / double{length});
  RayHit hit;
  scene.find_nearest({&from, 1}, {&direction, 1}, length + kKeepAway, {&hit, 1});
  if (hit.surface == RayHit::kNone) return end;
  return start + math::Vec3d(direction) * double{std::clamp(hit.distance - kKeepAway, 0.0f, length)};
}

// Adds the open place for a point of the grid.
void add_place(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, const math::Vec3d& on_plane,
               SamplePoints& io_places) {
  const world::Level& level = *lit.level;
  const math::Vec3d lift = grid.normal * kLift;
  const math::Vec3d inside = move_inside_face(grid, on_plane);
  OpenPlace place = move_into_open(level, inside + lift, grid.middle_world + lift);
  if (is_open(place) && inside != on_plane)
    if (const OpenPlace farther = look_at(level, find_farthest_open(scene, place.place, on_plane + lift));
        is_open(farther))
      place = farther;
  io_places.points.emplace_back(place.place);
  io_places.leaves.push_back(place.leaf);
}

}  // namespace

LightGrid make_light_grid(const LitLevel& lit, std::size_t map) {
  const world::Level& level = *lit.level;
  const LightMapShape& shape = lit.maps[map];
  const std::size_t number = shape.face;
  const world::Face& face = level.faces[number];
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const world::FacePlane plane = world::compute_face_plane(level, face);
  LightGrid grid;
  grid.face = number;
  grid.map = map;
  grid.width = shape.width;
  grid.height = shape.height;
  grid.normal = plane.normal;
  grid.corners_world = lit.corners_world(number);
  for (const math::Vec3d& corner : grid.corners_world)
    grid.middle_world += corner / static_cast<double>(grid.corners_world.size());

  if (shape.is_decoupled) {
    const LuxelPlaces places = find_luxel_places(level, shape);
    grid.origin_world = math::Vec3d(lit.model_offset(number)) + places.first;
    grid.column_step = places.per_x;
    grid.row_step = places.per_y;
    return grid;
  }
  const math::Vec3d s(axes.s_axis), t(axes.t_axis), n = plane.normal;
  const double volume = glm::dot(glm::cross(s, t), n);
  grid.origin_world = grid.middle_world;
  if (std::abs(volume) < kMinVolume * glm::length(s) * glm::length(t) || volume == 0) return grid;
  // Columns of the inverse of the matrix with rows s, t, n: how far a point moves for a step along each of
  // them.
  const math::Vec3d by_s = glm::cross(t, n) / volume, by_t = glm::cross(n, s) / volume,
                    by_n = glm::cross(s, t) / volume;
  grid.column_step = by_s * double(shape.texels);
  grid.row_step = by_t * double(shape.texels);
  grid.origin_world = math::Vec3d(lit.model_offset(number)) +
                      by_s * (double(shape.texture_mins[0]) - double{axes.s_offset}) +
                      by_t * (double(shape.texture_mins[1]) - double{axes.t_offset}) + by_n * plane.distance;
  return grid;
}

SamplePoints sample_points(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, int per_luxel) {
  SamplePoints places;
  const int columns = grid.width * per_luxel, rows = grid.height * per_luxel;
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  places.points.reserve(count);
  places.leaves.reserve(count);
  // The center of part i of the square around its luxel.
  const auto along = [&](int i) { return (i + 0.5) / per_luxel - 0.5; };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      add_place(lit, scene, grid,
                grid.origin_world + grid.column_step * along(column) + grid.row_step * along(row), places);
  return places;
}

SamplePoints sample_luxels(const LitLevel& lit, const RayScene& scene, const LightGrid& grid,
                           std::span<const std::uint32_t> luxels) {
  SamplePoints places;
  places.points.reserve(luxels.size());
  places.leaves.reserve(luxels.size());
  for (const std::uint32_t luxel : luxels) {
    const auto width = static_cast<std::uint32_t>(grid.width);
    add_place(
        lit, scene, grid,
        grid.origin_world + grid.column_step * double(luxel % width) + grid.row_step * double(luxel / width),
        places);
  }
  return places;
}

}  // namespace temblor::compiler
