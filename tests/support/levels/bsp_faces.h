// The corners of a face, directly from the edges of the file.
#pragma once

#include <cstdlib>
#include <vector>

#include "formats/levels/bsp.h"

namespace temblor::test {

inline std::vector<math::Vec3> list_vertices(const formats::Bsp& bsp, const formats::BspFace& face) {
  std::vector<math::Vec3> vertices;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const std::int32_t surfedge = bsp.surfedges[face.first_surfedge + i];
    const formats::BspEdge& edge = bsp.edges[static_cast<std::size_t>(std::abs(surfedge))];
    vertices.push_back(bsp.vertices[edge.vertices[surfedge < 0 ? 1 : 0]]);
  }
  return vertices;
}

}  // namespace temblor::test
