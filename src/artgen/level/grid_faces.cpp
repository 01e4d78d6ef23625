#include "artgen/level/grid_faces.h"

#include <algorithm>
#include <optional>

namespace temblor::artgen {
namespace {

// Faces are visible from these contents. Nothing is visible from inside the sky.
bool is_open(const Cell& cell) {
  return cell.contents == kContentsEmpty || cell.contents == kContentsWater;
}

Material wall_material(CellLook look) {
  switch (look) {
    case CellLook::kTrim:
      return Material::kTrim;
    case CellLook::kPanel:
      return Material::kPanel;
    case CellLook::kDoor:
      return Material::kDoor;
    case CellLook::kCourt:
      return Material::kStone;
    case CellLook::kCorridor:
    case CellLook::kCellar:
      return Material::kConcrete;
    case CellLook::kHall:
    case CellLook::kNone:
      break;
  }
  return Material::kBrick;
}

Material floor_material(CellLook look) {
  switch (look) {
    case CellLook::kCourt:
    case CellLook::kCellar:
      return Material::kEarth;
    case CellLook::kHall:
    case CellLook::kCorridor:
      return Material::kSlabs;
    default:
      return wall_material(look);
  }
}

// The material of the surface between the open cell `from` and the cell `to` next to it. Returns nothing
// where no surface is: between cells of the same contents, or if `from` is not open. `is_positive`: the
// surface's normal points along the positive axis, so on axis z it is a floor.
std::optional<Material> choose_material(const Cell& from, const Cell& to, std::size_t axis,
                                        bool is_positive) {
  if (!is_open(from) || from.contents == to.contents) return std::nullopt;
  if (to.contents == kContentsSky) return Material::kSky;
  if (is_open(to)) return Material::kWater;
  const CellLook look = to.look != CellLook::kNone ? to.look : from.look;
  if (axis != 2) return wall_material(look);
  if (is_positive) return floor_material(look);
  return look == CellLook::kHall ? Material::kConcrete : wall_material(look);
}

// One cell side in a plane. A face only merges equal squares, so that a wall is cut at the surface of water.
struct Square {
  Material material;
  // The contents in front of the square.
  std::int32_t front_contents;
  bool operator==(const Square&) const = default;
};

// The visible squares of one side of a plane. Rectangles are cut from them until none is left.
class Squares {
 public:
  Squares(const CellGrid& grid, const GridTree::Node& node, bool is_positive);
  std::vector<GridFace> cut_faces(float max_units);

 private:
  std::optional<Square>& at(std::size_t i, std::size_t j) {
    return squares_[(j - first_[1]) * width_ + i - first_[0]];
  }
  std::size_t find_limit(std::size_t which_axis, std::size_t from, float max_units) const;

  const CellGrid& grid_;
  // Provides the axis, line, and direction of all faces.
  GridFace shape_;
  std::array<std::size_t, 2> first_, last_;
  std::size_t width_;
  std::vector<std::optional<Square>> squares_;
};

Squares::Squares(const CellGrid& grid, const GridTree::Node& node, bool is_positive)
    : grid_(grid), shape_{node.axis, node.line, is_positive, {}, {}, {}} {
  const std::size_t u = shape_.u();
  const std::size_t v = shape_.v();
  first_ = {node.range.first[u], node.range.first[v]};
  last_ = {node.range.last[u], node.range.last[v]};
  width_ = last_[0] - first_[0];
  CellPosition above{}, below{};
  above[node.axis] = node.line;
  below[node.axis] = node.line - 1;
  for (std::size_t j = first_[1]; j < last_[1]; ++j) {
    for (std::size_t i = first_[0]; i < last_[0]; ++i) {
      above[u] = below[u] = i;
      above[v] = below[v] = j;
      const Cell& front = grid.at(is_positive ? above : below);
      const Cell& back = grid.at(is_positive ? below : above);
      const std::optional<Material> material = choose_material(front, back, node.axis, is_positive);
      squares_.push_back(material ? std::optional(Square{*material, front.contents}) : std::nullopt);
    }
  }
}

// The last line that a face may extend to if it starts at line `from`. `which_axis`: 0 for u, 1 for v.
std::size_t Squares::find_limit(std::size_t which_axis, std::size_t from, float max_units) const {
  const std::vector<float>& lines = grid_.lines[which_axis == 0 ? shape_.u() : shape_.v()];
  std::size_t to = from + 1;
  while (to < last_[which_axis] && lines[to + 1] - lines[from] <= max_units) ++to;
  return to;
}

// Greedy: start at the first square that is left, extend it along u as far as squares are equal, then along v
// as far as whole rows are equal.
std::vector<GridFace> Squares::cut_faces(float max_units) {
  std::vector<GridFace> faces;
  for (std::size_t j = first_[1]; j < last_[1]; ++j) {
    for (std::size_t i = first_[0]; i < last_[0]; ++i) {
      const std::optional<Square> square = at(i, j);
      if (!square) continue;
      const std::size_t max_i = find_limit(0, i, max_units);
      const std::size_t max_j = find_limit(1, j, max_units);
      std::size_t end_i = i + 1;
      while (end_i < max_i && at(end_i, j) == square) ++end_i;
      const auto row_matches = [&](std::size_t row) {
        for (std::size_t k = i; k < end_i; ++k)
          if (at(k, row) != square) return false;
        return true;
      };
      std::size_t end_j = j + 1;
      while (end_j < max_j && row_matches(end_j)) ++end_j;
      for (std::size_t row = j; row < end_j; ++row)
        for (std::size_t k = i; k < end_i; ++k) at(k, row).reset();
      GridFace face = shape_;
      face.first = {i, j};
      face.last = {end_i, end_j};
      face.material = square->material;
      faces.push_back(face);
    }
  }
  return faces;
}

// The grid point at two lines of the face's plane.
CellPosition make_position(const GridFace& face, std::size_t u_line, std::size_t v_line) {
  CellPosition point{};
  point[face.axis] = face.line;
  point[face.u()] = u_line;
  point[face.v()] = v_line;
  return point;
}

}  // namespace

CellRange GridFace::front_cells() const {
  CellRange range;
  range.first[axis] = is_positive ? line : line - 1;
  range.last[axis] = range.first[axis] + 1;
  range.first[u()] = first[0];
  range.last[u()] = last[0];
  range.first[v()] = first[1];
  range.last[v()] = last[1];
  return range;
}

std::vector<GridFace> find_faces(const CellGrid& grid, const GridTree::Node& node, float max_units) {
  std::vector<GridFace> faces = Squares(grid, node, true).cut_faces(max_units);
  const std::vector<GridFace> below = Squares(grid, node, false).cut_faces(max_units);
  faces.insert(faces.end(), below.begin(), below.end());
  return faces;
}

Corners::Corners(const CellGrid& grid, const std::vector<GridFace>& faces)
    : points_{grid.lines[0].size(), grid.lines[1].size(), grid.lines[2].size()},
      is_corner_(points_[0] * points_[1] * points_[2]) {
  for (const GridFace& face : faces)
    for (const std::size_t i : {face.first[0], face.last[0]})
      for (const std::size_t j : {face.first[1], face.last[1]})
        is_corner_[index(make_position(face, i, j))] = true;
}

std::vector<math::Vec3> trace_outline(const CellGrid& grid, const GridFace& face, const Corners& corners) {
  std::vector<CellPosition> points;
  const auto visit = [&](std::size_t i, std::size_t j) {
    const CellPosition point = make_position(face, i, j);
    if (corners.has(point)) points.push_back(point);
  };
  // u x v is the positive axis, so this walk is counter-clockwise as seen from the positive side.
  for (std::size_t i = face.first[0]; i < face.last[0]; ++i) visit(i, face.first[1]);
  for (std::size_t j = face.first[1]; j < face.last[1]; ++j) visit(face.last[0], j);
  for (std::size_t i = face.last[0]; i > face.first[0]; --i) visit(i, face.last[1]);
  for (std::size_t j = face.last[1]; j > face.first[1]; --j) visit(face.first[0], j);
  if (face.is_positive) std::reverse(points.begin(), points.end());
  std::vector<math::Vec3> vertices;
  for (const CellPosition& point : points)
    vertices.emplace_back(grid.lines[0][point[0]], grid.lines[1][point[1]], grid.lines[2][point[2]]);
  return vertices;
}

}  // namespace temblor::artgen
