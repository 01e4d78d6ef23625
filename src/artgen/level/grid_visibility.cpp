#include "artgen/level/grid_visibility.h"

#include <algorithm>
#include <array>

namespace temblor::artgen {
namespace {

constexpr std::uint32_t kNoLeaf = 0xffffffff;

// Calls visit(index) for every cell of a range.
template <typename Visit>
void for_each_cell(const CellGrid& grid, const CellRange& range, Visit visit) {
  for (std::size_t z = range.first[2]; z < range.last[2]; ++z)
    for (std::size_t y = range.first[1]; y < range.last[1]; ++y)
      for (std::size_t x = range.first[0]; x < range.last[0]; ++x) visit(grid.index({x, y, z}));
}

// Marks the cells that lines in one combination of directions can reach.
class Flood {
 public:
  explicit Flood(const CellGrid& grid) : grid_(grid) {}

  // Marks in io_seen all cells on lines that start in `from` and go up or down on each axis as `up` says.
  // Cells are visited in the order of the directions, so that one pass is enough. The outermost cells of a
  // grid are never open, so steps need no bounds check.
  void run(const CellRange& from, const std::array<bool, 3>& up, std::vector<std::uint8_t>& io_seen) {
    // A line continues behind a cell if the cell is open or if the line starts there, even inside a sky.
    passes_.assign(grid_.cells.size(), 0);
    const std::array<std::ptrdiff_t, 3> strides = {
        1, static_cast<std::ptrdiff_t>(grid_.size(0)),
        static_cast<std::ptrdiff_t>(grid_.size(0) * grid_.size(1))};
    for_each_cell(grid_, from, [&](std::size_t cell) { passes_[cell] = io_seen[cell] = 1; });
    for (std::size_t k = 1; k + 1 < grid_.size(2); ++k) {
      for (std::size_t j = 1; j + 1 < grid_.size(1); ++j) {
        for (std::size_t i = 1; i + 1 < grid_.size(0); ++i) {
          const std::size_t cell =
              grid_.index({up[0] ? i : grid_.size(0) - 1 - i, up[1] ? j : grid_.size(1) - 1 - j,
                           up[2] ? k : grid_.size(2) - 1 - k});
          const std::int32_t contents = grid_.cells[cell].contents;
          if (contents == kContentsSolid || passes_[cell] != 0) continue;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::ptrdiff_t back = up[axis] ? -strides[axis] : strides[axis];
            if (passes_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + back)] == 0) continue;
            io_seen[cell] = 1;
            passes_[cell] = contents != kContentsSky ? 1 : 0;
          }
        }
      }
    }
  }

 private:
  const CellGrid& grid_;
  // Kept between runs to avoid allocations.
  std::vector<std::uint8_t> passes_;
};

}  // namespace

std::vector<std::vector<std::uint8_t>> find_visible_leaves(const CellGrid& grid,
                                                           std::span<const GridTree::Leaf> leaves) {
  std::vector<std::uint32_t> leaf_by_cell(grid.cells.size(), kNoLeaf);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    for_each_cell(grid, leaves[leaf].range,
                  [&](std::size_t cell) { leaf_by_cell[cell] = static_cast<std::uint32_t>(leaf); });

  Flood flood(grid);
  std::vector<std::vector<std::uint8_t>> rows;
  for (const GridTree::Leaf& leaf : leaves) {
    std::vector<std::uint8_t> seen(grid.cells.size(), 0);
    for (unsigned octant = 0; octant < 8; ++octant)
      flood.run(leaf.range, {(octant & 1) != 0, (octant & 2) != 0, (octant & 4) != 0}, seen);
    std::vector<std::uint8_t> row((leaves.size() + 7) / 8);
    for (std::size_t cell = 0; cell < seen.size(); ++cell) {
      const std::uint32_t other = leaf_by_cell[cell];
      if (seen[cell] != 0 && other != kNoLeaf)
        row[other / 8] = static_cast<std::uint8_t>(row[other / 8] | (1u << (other % 8)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::uint8_t> compress_row(std::span<const std::uint8_t> row) {
  constexpr std::size_t kMaxRun = 255;
  std::vector<std::uint8_t> coded;
  for (std::size_t i = 0; i < row.size();) {
    coded.push_back(row[i]);
    if (row[i++] != 0) continue;
    std::size_t run = 1;
    while (i < row.size() && row[i] == 0 && run < kMaxRun) {
      ++run;
      ++i;
    }
    coded.push_back(static_cast<std::uint8_t>(run));
  }
  return coded;
}

}  // namespace temblor::artgen
