// Finds the faces of a grid: rectangles of cell sides between an open cell and a surface that is visible from
// it. Each face lies in the plane of a tree node. Outlines have no T-junctions: a face has a vertex wherever
// the corner of another face touches its border.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "artgen/level/grid.h"
#include "artgen/level/grid_tree.h"
#include "artgen/level/materials.h"

namespace temblor::artgen {

// A rectangle in the plane of `line` on `axis`. It extends from line `first` to line `last` on the axes u and
// v, where axis, u, and v are x, y, and z in cyclic order, so that u x v points along the positive axis.
struct GridFace {
  std::size_t axis;
  std::size_t line;
  // The face's normal points along the positive axis.
  bool is_positive;
  // Line indices on u and v.
  std::array<std::size_t, 2> first, last;
  Material material;

  std::size_t u() const { return (axis + 1) % 3; }
  std::size_t v() const { return (axis + 2) % 3; }
  // The open cells directly in front of the face.
  CellRange front_cells() const;
};

// Returns the faces in a node's plane, inside its range, for both sides of the plane. No face is longer than
// `max_units` unless a single cell is.
std::vector<GridFace> find_faces(const CellGrid& grid, const GridTree::Node& node, float max_units);

// The set of grid points that are a corner of any face.
class Corners {
 public:
  Corners(const CellGrid& grid, const std::vector<GridFace>& faces);
  bool has(const CellPosition& point) const { return is_corner_[index(point)]; }

 private:
  std::size_t index(const CellPosition& point) const {
    return (point[2] * points_[1] + point[1]) * points_[0] + point[0];
  }
  // The number of grid points on each axis.
  CellPosition points_;
  std::vector<bool> is_corner_;
};

// The face's vertices, clockwise as seen from its front, which is the order that Quake's faces have.
std::vector<math::Vec3> trace_outline(const CellGrid& grid, const GridFace& face, const Corners& corners);

}  // namespace temblor::artgen
