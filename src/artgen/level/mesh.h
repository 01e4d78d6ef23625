// Stores loops of vertices as the BSP format does: each vertex once, and edges shared between neighboring
// faces, which refer to them by surfedges. A negative surfedge is an edge in reverse direction.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>

#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::artgen {

// A face's range in the level's surfedges.
struct SurfedgeRange {
  std::uint32_t first, count;
};

// Appends to the vertices, edges, and surfedges of a level, which must be empty at first and must outlive the
// mesh.
class LevelMesh {
 public:
  // Stock compilers let at most two faces use an edge, once in each direction. `share_without_limit` lifts
  // that limit, as some other compilers do.
  LevelMesh(formats::Bsp& io_bsp, bool share_without_limit);

  // Adds a closed loop, clockwise as seen from the face's front.
  SurfedgeRange add_loop(std::span<const math::Vec3> vertices);

 private:
  std::uint32_t add_vertex(const math::Vec3& position);
  std::int32_t add_surfedge(std::uint32_t from, std::uint32_t to);

  using Ends = std::array<std::uint32_t, 2>;
  formats::Bsp& bsp_;
  bool share_without_limit_;
  std::map<std::array<float, 3>, std::uint32_t> vertices_;
  // By start and end: edges that another face can still use in the reverse direction.
  std::multimap<Ends, std::uint32_t> open_edges_;
};

}  // namespace temblor::artgen
