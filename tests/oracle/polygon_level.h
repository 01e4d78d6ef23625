// Levels of a few polygons, written by hand, for testing the oracle itself.
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

// One level model per element (the first is the world), all faces lit; one open leaf everywhere. The only
// texture is 16 x 16 and holds texel (s, t) = 16 t + s; s = x and t = y in model space. No face has light
// samples.
world::Level make_polygon_level(std::span<const PolygonModel> models);

}  // namespace temblor::oracle
