#include "artgen/level/grid.h"

#include <algorithm>
#include <cmath>

namespace temblor::artgen {
namespace {

// The width of the background layer around the boxes.
constexpr float kBorderUnits = 16;

void sort_unique(std::vector<float>& io_values) {
  std::sort(io_values.begin(), io_values.end());
  io_values.erase(std::unique(io_values.begin(), io_values.end()), io_values.end());
}

// Inserts lines so that no two neighbors are more than `max_units` apart.
void cut_wide_cells(std::vector<float>& io_lines, float max_units) {
  const std::vector<float> lines = io_lines;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    for (float cut = lines[i] + max_units; cut < lines[i + 1]; cut += max_units) io_lines.push_back(cut);
  sort_unique(io_lines);
}

template <typename Visit>
void for_each_cell(const CellGrid& grid, Visit visit) {
  for (std::size_t z = 0; z < grid.size(2); ++z)
    for (std::size_t y = 0; y < grid.size(1); ++y)
      for (std::size_t x = 0; x < grid.size(0); ++x) visit(CellPosition{x, y, z});
}

float cell_center(const CellGrid& grid, std::size_t axis, std::size_t cell) {
  return (grid.lines[axis][cell] + grid.lines[axis][cell + 1]) / 2;
}

bool contains_point(const math::Bounds& bounds, const math::Vec3& point) {
  for (int axis = 0; axis < 3; ++axis)
    if (point[axis] < bounds.mins[axis] || point[axis] > bounds.maxs[axis]) return false;
  return true;
}

// Sky stops boxes, although it is not solid for light.
bool is_obstacle(const Cell& cell) {
  return cell.contents == kContentsSolid || cell.contents == kContentsSky;
}

// The range of cells on one axis that the open interval from `low` to `high` touches.
struct TouchedCells {
  std::size_t first, last;
};
TouchedCells find_touched_cells(const std::vector<float>& lines, float low, float high) {
  const auto first = std::upper_bound(lines.begin(), lines.end(), low) - lines.begin() - 1;
  const auto last = std::lower_bound(lines.begin(), lines.end(), high) - lines.begin();
  const auto cells = static_cast<std::ptrdiff_t>(lines.size()) - 1;
  return {static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(first, 0, cells)),
          static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(last, 0, cells))};
}

// A range that is empty on some axis lies outside the grid, in the background.
bool has_obstacle(const CellGrid& grid, const std::array<TouchedCells, 3>& range, bool is_background_solid) {
  for (const TouchedCells& touched : range)
    if (touched.first >= touched.last) return is_background_solid;
  for (std::size_t z = range[2].first; z < range[2].last; ++z)
    for (std::size_t y = range[1].first; y < range[1].last; ++y)
      for (std::size_t x = range[0].first; x < range[0].last; ++x)
        if (is_obstacle(grid.at({x, y, z}))) return true;
  return false;
}

}  // namespace

math::Bounds CellGrid::bounds(const CellRange& range) const {
  math::Bounds box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.mins[static_cast<int>(axis)] = lines[axis][range.first[axis]];
    box.maxs[static_cast<int>(axis)] = lines[axis][range.last[axis]];
  }
  return box;
}

CellGrid make_grid(std::span<const LayoutBox> boxes, std::int32_t background, float max_cell_units) {
  CellGrid grid;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<float>& lines = grid.lines[axis];
    for (const LayoutBox& box : boxes) {
      lines.push_back(box.bounds.mins[static_cast<int>(axis)]);
      lines.push_back(box.bounds.maxs[static_cast<int>(axis)]);
    }
    sort_unique(lines);
    cut_wide_cells(lines, max_cell_units);
    lines.insert(lines.begin(), lines.front() - kBorderUnits);
    lines.push_back(lines.back() + kBorderUnits);
  }
  for_each_cell(grid, [&](const CellPosition& at) {
    const math::Vec3 middle(cell_center(grid, 0, at[0]), cell_center(grid, 1, at[1]),
                            cell_center(grid, 2, at[2]));
    Cell cell{background, CellLook::kNone};
    // The last box that contains the cell's center wins. The cell lies inside it completely, because all
    // sides of boxes are lines of the grid.
    for (const LayoutBox& box : boxes)
      if (contains_point(box.bounds, middle)) cell = {box.contents, box.look};
    grid.cells.push_back(cell);
  });
  return grid;
}

CellGrid grow_grid(const CellGrid& grid, const math::Vec3& mins, const math::Vec3& maxs,
                   std::int32_t background) {
  CellGrid grown;
  std::array<std::vector<TouchedCells>, 3> touched;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // A box around a point touches a plane exactly when the point lies within `-high` and `-low` of it.
    // Between these shifted planes the answer is constant, so one test at the center of each new cell is
    // enough.
    const float low = mins[static_cast<int>(axis)];
    const float high = maxs[static_cast<int>(axis)];
    for (const float line : grid.lines[axis]) {
      grown.lines[axis].push_back(line - high);
      grown.lines[axis].push_back(line - low);
    }
    sort_unique(grown.lines[axis]);
    for (std::size_t cell = 0; cell < grown.size(axis); ++cell) {
      const float middle = cell_center(grown, axis, cell);
      touched[axis].push_back(find_touched_cells(grid.lines[axis], middle + low, middle + high));
    }
  }
  const bool is_background_solid = background == kContentsSolid;
  for_each_cell(grown, [&](const CellPosition& at) {
    const bool stops =
        has_obstacle(grid, {touched[0][at[0]], touched[1][at[1]], touched[2][at[2]]}, is_background_solid);
    grown.cells.push_back({stops ? kContentsSolid : kContentsEmpty, CellLook::kNone});
  });
  return grown;
}

}  // namespace temblor::artgen
