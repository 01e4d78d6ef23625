// The range of a face's texture coordinates.
#pragma once

#include "world/level.h"

namespace temblor::world {

struct TexelRange {
  double min, max;  // in texels; each is exactly a float
};

// The range over the face's vertices along one axis: 0: s, 1: t. Uses only the face's surfedges and axes.
TexelRange find_texel_range(const Level& level, const Face& face, int axis);

}  // namespace temblor::world
