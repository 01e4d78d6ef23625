// A hull of one model, divided into cells for many short traces and points in the same places.
//
// A trace through a level's hull starts at the head of the tree, and most planes on its way down are far from
// the path. A cell keeps only the part of the tree that its box meets:
//
//   whole tree:   [x=0] -> [y=9] -> [z=4] -> [x=7] -> [y=2] -> solid, empty
//   in the cell:                    [z=4] -> solid, empty             (the other planes do not cut its box)
//
// A node whose plane does not cut the box is replaced by the child on the box's side, and a node below which
// all leaves have the same contents by these contents. Neither changes a trace inside the box, so the results
// are those of world/trace.h, bit for bit. A path that leaves its cell's box is traced through the whole
// tree. Cells are made when they are first needed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "world/level.h"
#include "world/trace.h"

namespace temblor::world {

class HullCells {
 public:
  // `level` must outlive it.
  HullCells(const Level& level, ModelIndex model, Hull hull);

  // The same as world::trace_line() and world::hull_contents(), in the model's space.
  Trace trace_line(const math::Vec3& start, const math::Vec3& end);
  Contents contents(const math::Vec3& point);

 private:
  struct Cell {
    bool is_made = false;
    std::int32_t head = 0;
  };

  // Returns the part of the hull around the cell of `start`, or around the current cell; nothing if the path
  // is in neither box.
  std::optional<HullPart> find_part(const math::Vec3& start, const math::Vec3& end);
  bool enter_cell(const math::Vec3& at);
  std::int32_t copy_part(std::int32_t node, const math::Bounds& box);

  const Level* level_;
  ModelIndex model_;
  Hull hull_;
  math::Vec3 low_;  // corner of the grid
  float cell_units_ = 0;
  std::array<int, 3> counts_{};  // cells along x, y, and z
  std::vector<Cell> cells_;      // by z, y, and x
  // The current cell's box and tree. No point is inside the first box.
  math::Bounds box_{math::Vec3(1.0f), math::Vec3(-1.0f)};
  std::int32_t head_ = 0;
  std::vector<Clipnode> clipnodes_;  // of all cells
};

}  // namespace temblor::world
