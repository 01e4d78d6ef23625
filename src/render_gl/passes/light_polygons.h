// A dynamic light on a tile of a face, as triangles with light at their corners. The CPU's light falls by one
// for each unit of distance on the face, and that distance is the longer offset along the texture axes plus
// half of the shorter one (face_lights.h). So points of equal light form an octagon, and within each eighth
// of it light is linear:
//
//        . - + - .
//      .  \  |  /  .      Interpolation between corners, which cards have, is exact here.
//     +----- o -----+     The CPU samples light every 16 texels, and interpolates
//      .  /  |  \  .      between samples.
//        ' - + - '
#pragma once

#include <span>
#include <vector>

#include "render/edges/face_outlines.h"
#include "render/surfaces/light/face_lights.h"

namespace temblor::render_gl {

// The corner of a triangle, in model space. `light` is in units, as DynamicLight::radius.
struct LightCorner {
  math::Vec3 position;
  float light;
};

// A face, and the tile of it that shows.
struct LightPolygonFace {
  const world::Level& level;
  const world::Face& face;
  std::span<const render::OutlineCorner> corners;
  int tile_s = 0, tile_t = 0;
};

// Cuts the light's octagon along the face and its tile, and appends three corners for each triangle.
// Triangles do not overlap, and have no gaps between them.
void add_light_polygons(const LightPolygonFace& face, const render::FaceLight& light,
                        std::vector<LightCorner>& io_triangles);

}  // namespace temblor::render_gl
