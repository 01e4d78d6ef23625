// The faces of a grid: rectangles of cell sides between an open cell and something to look at.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "artgen/level/grid.h"
#include "artgen/level/grid_tree.h"
#include "artgen/level/materials.h"

namespace temblor::artgen {

// A rectangle in the plane of `line` on `axis`, from first to last line on the two axes after it (`u` is axis
// + 1, `v` axis + 2, around the corner).
struct GridFace {
  std::size_t axis;
  std::size_t line;
  bool looks_up;  // along the positive axis
  std::array<std::size_t, 2> first, last;
  Material material;

  std::size_t u() const { return (axis + 1) % 3; }
  std::size_t v() const { return (axis + 2) % 3; }
  // The open cells right in front.
  CellRange front_cells() const;
};

// The faces that lie in a node's plane, inside its range. None is longer than `max_units`.
std::vector<GridFace> find_faces(const CellGrid& grid, const GridTree::Node& node, float max_units);

// Which points of a grid are corners of faces. A face's outline has a vertex at each that lies on its border,
// so that no edge ends in the middle of another face's.
class Corners {
 public:
  Corners(const CellGrid& grid, const std::vector<GridFace>& faces);
  bool has(const CellPosition& point) const { return is_corner_[index(point)]; }

 private:
  std::size_t index(const CellPosition& point) const {
    return (point[2] * points_[1] + point[1]) * points_[0] + point[0];
  }
  CellPosition points_;
  std::vector<bool> is_corner_;
};

// The face's vertices, clockwise seen from its front.
std::vector<math::Vec3> outline(const CellGrid& grid, const GridFace& face, const Corners& corners);

}  // namespace temblor::artgen
