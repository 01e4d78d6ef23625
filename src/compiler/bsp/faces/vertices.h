// The corners of a level's faces, each place once, and faces as loops of them that meet without gaps.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "compiler/bsp/winding.h"

namespace temblor::compiler {

class VertexSet {
 public:
  // Points nearer than kSamePlace are one.
  static constexpr double kSamePlace = 0.03;  // units
  std::uint32_t find_or_add(const math::Vec3d& point);

  std::span<const math::Vec3d> points() const { return points_; }

  // Calls body(vertex) for each one in the box, and for some around it.
  template <typename Body>
  void for_each_near(const Box& box, Body body) const {
    const Cell first = cell_of(box.mins - kSamePlace), last = cell_of(box.maxs + kSamePlace);
    for (std::int64_t x = first.x; x <= last.x; ++x)
      for (std::int64_t y = first.y; y <= last.y; ++y)
        for (std::int64_t z = first.z; z <= last.z; ++z) {
          const auto [begin, end] = by_cell_.equal_range(key_of({x, y, z}));
          for (auto it = begin; it != end; ++it) body(it->second);
        }
  }

 private:
  static constexpr double kCellUnits = 64;
  struct Cell {
    std::int64_t x, y, z;
  };
  static Cell cell_of(const math::Vec3d& point);
  static std::int64_t key_of(const Cell& cell);

  std::vector<math::Vec3d> points_;
  std::unordered_multimap<std::int64_t, std::uint32_t> by_cell_;
};

using FaceLoop = std::vector<std::uint32_t>;

// Puts every vertex that lies on a loop's side into the loop, so that faces on both sides have the same
// corners along it: no T-junctions, through whose rounding the background would shine. Vertices given twice
// in a row go.
void close_t_junctions(std::vector<FaceLoop>& io_loops, const VertexSet& vertices);

}  // namespace temblor::compiler
