// Loops of vertices as a level stores them: vertices once, edges shared between neighboring faces.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>

#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::artgen {

struct SurfedgeRange {
  std::uint32_t first, count;
};

// Writes into the vertices, edges and surfedges of a level, which must outlive it and be empty at first.
class LevelMesh {
 public:
  // An edge is used by two faces at most, once in each direction, unless `share_without_limit`.
  LevelMesh(formats::Bsp& io_bsp, bool share_without_limit);

  SurfedgeRange add_loop(std::span<const math::Vec3> vertices);

 private:
  std::uint32_t add_vertex(const math::Vec3& position);
  std::int32_t add_surfedge(std::uint32_t from, std::uint32_t to);

  using Ends = std::array<std::uint32_t, 2>;
  formats::Bsp& bsp_;
  bool share_without_limit_;
  std::map<std::array<float, 3>, std::uint32_t> vertices_;
  std::multimap<Ends, std::uint32_t> open_edges_;  // which can take one more face, against their direction
};

}  // namespace temblor::artgen
