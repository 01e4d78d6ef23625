// The positions of a model's vertices, by the definition of the format.
#pragma once

#include "formats/models/mdl.h"
#include "math/vec.h"

namespace temblor::test {

inline math::Vec3d vertex_position(const formats::Mdl& mdl, std::size_t frame, std::size_t vertex) {
  const auto& bytes = mdl.frames[frame].poses.front().vertices[vertex].position;
  return math::Vec3d(mdl.scale) * math::Vec3d(bytes[0], bytes[1], bytes[2]) + math::Vec3d(mdl.origin);
}

struct Extent {
  math::Vec3d low{1e9}, high{-1e9};
};

inline Extent frame_extent(const formats::Mdl& mdl, std::size_t frame) {
  Extent extent;
  for (std::size_t i = 0; i < mdl.texels.size(); ++i) {
    extent.low = glm::min(extent.low, vertex_position(mdl, frame, i));
    extent.high = glm::max(extent.high, vertex_position(mdl, frame, i));
  }
  return extent;
}

}  // namespace temblor::test
