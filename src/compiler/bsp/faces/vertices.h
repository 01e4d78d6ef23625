// The vertices of a level, each stored once, and faces as loops of vertices that meet without gaps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "compiler/bsp/winding.h"

namespace temblor::compiler {

// A spatial hash of points.
class VertexSet {
 public:
  // Returns the vertex at a point. Points nearer than kSamePlace are one vertex.
  static constexpr double kSamePlace = 0.03;  // units
  std::uint32_t find_or_add(const math::Vec3d& point);

  std::span<const math::Vec3d> points() const { return points_; }

  // Calls body(vertex) for each vertex in the box, and for some around it.
  template <typename Body>
  void for_each_near(const Box& box, Body body) const {
    const Cell first = find_cell(box.mins - kSamePlace), last = find_cell(box.maxs + kSamePlace);
    for (std::int64_t x = first.x; x <= last.x; ++x)
      for (std::int64_t y = first.y; y <= last.y; ++y)
        for (std::int64_t z = first.z; z <= last.z; ++z) {
          const auto [begin, end] = by_cell_.equal_range(make_key({x, y, z}));
          for (auto it = begin; it != end; ++it) body(it->second);
        }
  }

 private:
  static constexpr double kCellUnits = 64;
  struct Cell {
    std::int64_t x, y, z;
  };
  static Cell find_cell(const math::Vec3d& point);
  static std::int64_t make_key(const Cell& cell);

  std::vector<math::Vec3d> points_;
  std::unordered_multimap<std::int64_t, std::uint32_t> by_cell_;
};

using FaceLoop = std::vector<std::uint32_t>;

// Closes T-junctions: inserts every vertex on a side of a loop into that loop, so that faces on both sides of
// an edge have the same vertices along it. Otherwise the background would shine through in single pixels.
// Removes vertices that are repeated in a row.
void close_t_junctions(std::vector<FaceLoop>& io_loops, const VertexSet& vertices);

// Splits a convex loop into convex loops of at most `max_vertices` (4 or more) along lines between its
// vertices.
std::vector<FaceLoop> split_long_loop(FaceLoop loop, std::size_t max_vertices, const VertexSet& vertices);

}  // namespace temblor::compiler
