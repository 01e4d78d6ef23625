#include "compiler/light/faces/sample_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "world/face_at.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

constexpr double kLift = 1;      // before the plane: what lies in the plane casts no shadow on it
constexpr double kMargin = 0.5;  // inside the face: what stands on its edge does not touch the sample
constexpr float kKeepAway = 1;   // from a wall that ends the way to a place
constexpr double kMinVolume = 1e-6;

// The nearest point of the face that keeps kMargin from its edges, as far as the face is that wide.
math::Vec3d inside_face(const LightGrid& grid, const math::Vec3d& point) {
  const std::vector<math::Vec3d>& corners = grid.corners_world;
  bool inside = true;
  double nearest_squared = std::numeric_limits<double>::infinity();
  math::Vec3d nearest = point;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const math::Vec3d start = corners[i], way = corners[(i + 1) % corners.size()] - start;
    const double length_squared = glm::dot(way, way);
    if (!(length_squared > 0)) continue;
    // Clockwise from the front: the inside is to the right of every side.
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
  const math::Vec3d inwards = grid.middle_world - nearest;
  const double length = glm::length(inwards);
  return length > 0 ? nearest + inwards * std::min(1.0, 2 * kMargin / length) : nearest;
}

struct OpenPlace {
  math::Vec3d place{0.0};
  world::LeafIndex leaf{0};
};

// The place and its leaf; leaf 0 where that is solid.
OpenPlace look_at(const world::Level& level, const math::Vec3d& place) {
  const world::LeafIndex leaf = world::find_leaf(level, math::Vec3(place));
  const bool solid = level.leaf(leaf).contents == world::Contents::kSolid;
  return {place, solid ? world::LeafIndex{0} : leaf};
}

bool is_open(const OpenPlace& place) {
  return place.leaf != world::LeafIndex{0};
}

// `place` moved towards the face's middle until it is in the open; where nothing is, `place` itself.
OpenPlace moved_into_open(const world::Level& level, const math::Vec3d& place, const math::Vec3d& middle) {
  constexpr std::array<double, 6> kTries{0.0, 0.02, 0.1, 0.25, 0.5, 1.0};
  for (const double share : kTries)
    if (const OpenPlace moved = look_at(level, place + (middle - place) * share); is_open(moved))
      return moved;
  return {place, world::LeafIndex{0}};
}

// From `start` towards `end`, as far as nothing is in the way.
math::Vec3d farthest_open(const RayScene& scene, const math::Vec3d& start, const math::Vec3d& end) {
  const auto length = static_cast<float>(glm::length(end - start));
  if (length <= 0) return end;
  const math::Vec3 from(start), direction((end - start) / double{length});
  RayHit hit;
  scene.nearest({&from, 1}, {&direction, 1}, length + kKeepAway, {&hit, 1});
  if (hit.surface == RayHit::kNone) return end;
  return start + math::Vec3d(direction) * double{std::clamp(hit.distance - kKeepAway, 0.0f, length)};
}

void add_place(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, const math::Vec3d& on_plane,
               SamplePlaces& io_places) {
  const world::Level& level = *lit.level;
  const math::Vec3d lift = grid.normal * kLift;
  const math::Vec3d inside = inside_face(grid, on_plane);
  OpenPlace place = moved_into_open(level, inside + lift, grid.middle_world + lift);
  if (is_open(place) && inside != on_plane)
    if (const OpenPlace farther = look_at(level, farthest_open(scene, place.place, on_plane + lift));
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
  const world::FacePlane plane = world::plane_of(level, face);
  LightGrid grid;
  grid.face = number;
  grid.map = map;
  grid.width = shape.width;
  grid.height = shape.height;
  grid.normal = plane.normal;
  grid.corners_world = lit.corners_world(number);
  for (const math::Vec3d& corner : grid.corners_world)
    grid.middle_world += corner / static_cast<double>(grid.corners_world.size());

  const math::Vec3d s(axes.s_axis), t(axes.t_axis), n = plane.normal;
  const double volume = glm::dot(glm::cross(s, t), n);
  grid.origin_world = grid.middle_world;
  if (std::abs(volume) < kMinVolume * glm::length(s) * glm::length(t) || volume == 0) return grid;
  // Columns of the inverse of the matrix with rows s, t, n: by how much a point moves for each of the three.
  const math::Vec3d by_s = glm::cross(t, n) / volume, by_t = glm::cross(n, s) / volume,
                    by_n = glm::cross(s, t) / volume;
  grid.column_step = by_s * double(shape.texels);
  grid.row_step = by_t * double(shape.texels);
  grid.origin_world = math::Vec3d(lit.offset_of(number)) +
                      by_s * (double(shape.texture_mins[0]) - double{axes.s_offset}) +
                      by_t * (double(shape.texture_mins[1]) - double{axes.t_offset}) + by_n * plane.distance;
  return grid;
}

SamplePlaces sample_points(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, int per_luxel) {
  SamplePlaces places;
  const int columns = grid.width * per_luxel, rows = grid.height * per_luxel;
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  places.points.reserve(count);
  places.leaves.reserve(count);
  // The middle of part i of the square around its luxel.
  const auto along = [&](int i) { return (i + 0.5) / per_luxel - 0.5; };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      add_place(lit, scene, grid,
                grid.origin_world + grid.column_step * along(column) + grid.row_step * along(row), places);
  return places;
}

SamplePlaces places_of_luxels(const LitLevel& lit, const RayScene& scene, const LightGrid& grid,
                              std::span<const std::uint32_t> luxels) {
  SamplePlaces places;
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
