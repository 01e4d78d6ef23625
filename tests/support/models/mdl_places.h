// Where the vertices of a model's frames are, from the format's definition.
#pragma once

#include "formats/models/mdl.h"
#include "math/vec.h"

namespace temblor::test {

inline math::Vec3d place_of(const formats::Mdl& mdl, std::size_t frame, std::size_t vertex) {
  const auto& bytes = mdl.frames[frame].poses.front().vertices[vertex].position;
  return math::Vec3d(mdl.scale) * math::Vec3d(bytes[0], bytes[1], bytes[2]) + math::Vec3d(mdl.origin);
}

struct Extent {
  math::Vec3d low{1e9}, high{-1e9};
};

inline Extent extent_of(const formats::Mdl& mdl, std::size_t frame) {
  Extent extent;
  for (std::size_t i = 0; i < mdl.texels.size(); ++i) {
    extent.low = glm::min(extent.low, place_of(mdl, frame, i));
    extent.high = glm::max(extent.high, place_of(mdl, frame, i));
  }
  return extent;
}

}  // namespace temblor::test
