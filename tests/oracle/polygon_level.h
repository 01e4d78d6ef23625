// Levels of a few polygons, written down by hand, for testing the oracle itself.
#pragma once

#include <span>
#include <vector>

#include "math/vec.h"
#include "world/level.h"

namespace temblor::oracle {

using PolygonVertices = std::vector<math::Vec3>;

// Clockwise seen from its front, as faces are.
struct PolygonModel {
  std::vector<PolygonVertices> polygons;
};

// One model each (the first is the world), all faces lit; one open leaf everywhere. The one texture is 16 x
// 16 and holds texel (s, t) = 16 t + s; s = x and t = y of the model's space. Light: none of the faces has
// samples.
world::Level make_polygon_level(std::span<const PolygonModel> models);

}  // namespace temblor::oracle
