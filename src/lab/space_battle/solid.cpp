#include "lab/space_battle/solid.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace temblor::lab::space {

namespace {

using math::Vec2d;
using math::Vec3d;

std::uint32_t to_number(std::size_t count) {
  return static_cast<std::uint32_t>(count);
}

void add_face(Solid& io_solid, std::span<const std::uint32_t> corners) {
  // Half the sum is the area, with the direction of the normal (Newell). It is also right for concave faces.
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum -= glm::cross(io_solid.corners[corners[i]], io_solid.corners[corners[(i + 1) % corners.size()]]);
  const Vec3d normal = glm::normalize(sum);
  io_solid.faces.push_back({to_number(io_solid.sides.size()), to_number(corners.size()), normal,
                            glm::dot(normal, io_solid.corners[corners[0]])});
  for (const std::uint32_t corner : corners) io_solid.sides.push_back({corner, 0});
}

// The neighbor has the same side in the other direction.
std::uint32_t find_neighbor(const Solid& solid, std::uint32_t from, std::uint32_t to) {
  for (std::size_t face = 0; face < solid.faces.size(); ++face) {
    const std::span<const SolidSide> sides = solid.list_sides(solid.faces[face]);
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i].corner == to && sides[(i + 1) % sides.size()].corner == from) return to_number(face);
  }
  CHECK(false, "the solid has a hole");
  return 0;
}

void find_neighbors(Solid& io_solid) {
  for (const SolidFace& face : io_solid.faces)
    for (std::uint32_t i = 0; i < face.side_count; ++i) {
      const std::uint32_t next = face.first_side + (i + 1) % face.side_count;
      SolidSide& side = io_solid.sides[face.first_side + i];
      side.neighbor = find_neighbor(io_solid, side.corner, io_solid.sides[next].corner);
    }
}

}  // namespace

Solid make_solid(std::span<const Vec2d> outline, double half_height, double shrink) {
  const std::uint32_t count = to_number(outline.size());
  Solid solid;
  std::vector<std::uint32_t> top, bottom;
  for (const Vec2d& point : outline) solid.corners.emplace_back(point, 0.0);
  for (const Vec2d& point : outline) {
    top.insert(top.begin(), to_number(solid.corners.size()));  // clockwise
    solid.corners.emplace_back(point * shrink, half_height);
  }
  for (const Vec2d& point : outline) {
    bottom.push_back(to_number(solid.corners.size()));
    solid.corners.emplace_back(point * shrink, -half_height);
  }
  add_face(solid, top);
  add_face(solid, bottom);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    add_face(solid, std::array{i, count + i, count + next, next});
    add_face(solid, std::array{i, next, 2 * count + next, 2 * count + i});
  }
  find_neighbors(solid);
  for (const Vec3d& corner : solid.corners) solid.radius = std::max(solid.radius, glm::length(corner));
  return solid;
}

std::vector<Solid> make_convex_ships() {
  constexpr Vec2d kFighter[] = {{1, 0}, {-0.5, 0.6}, {-0.75, 0}, {-0.5, -0.6}};
  constexpr Vec2d kFreighter[] = {{0.95, 0},     {0.6, 0.35},  {-0.7, 0.4},
                                  {-0.85, 0.15}, {-0.7, -0.4}, {0.6, -0.35}};
  constexpr Vec2d kRock[] = {{0.7, 0.1},   {0.4, 0.6},   {-0.2, 0.7},  {-0.65, 0.35},
                             {-0.7, -0.2}, {-0.2, -0.7}, {0.45, -0.55}};
  return {make_solid(kFighter, 0.25, 0.3), make_solid(kFreighter, 0.3, 0.7), make_solid(kRock, 0.5, 0.5)};
}

std::vector<Solid> make_concave_ships() {
  constexpr Vec2d kArrow[] = {{1, 0}, {-0.7, 0.7}, {-0.3, 0}, {-0.7, -0.7}};
  constexpr Vec2d kWings[] = {{1, 0},        {0.25, 0.18}, {0.1, 0.9},   {-0.3, 0.9},
                              {-0.35, 0.22}, {-0.8, 0.3},  {-0.8, -0.3}, {-0.35, -0.22},
                              {-0.3, -0.9},  {0.1, -0.9},  {0.25, -0.18}};
  constexpr Vec2d kStar[] = {{0.95, 0},  {0.25, 0.25},   {0, 0.95},  {-0.25, 0.25},
                             {-0.95, 0}, {-0.25, -0.25}, {0, -0.95}, {0.25, -0.25}};
  return {make_solid(kArrow, 0.22, 0.4), make_solid(kWings, 0.2, 0.6), make_solid(kStar, 0.3, 0.5)};
}

Solid make_shot() {
  constexpr Vec2d kBolt[] = {{0.5, 0}, {-0.4, 0.05}, {-0.4, -0.05}};
  return make_solid(kBolt, 0.04, 0.5);
}

}  // namespace temblor::lab::space
