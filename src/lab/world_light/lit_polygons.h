// Convex polygons with light at their corners, on the screen: clipped to the frustum, and cut into rows.
//
// On a row, light is interpolated down the two edges that the row crosses, then along the row (Henri Gouraud,
// "Continuous Shading of Curved Surfaces", 1971).
#pragma once

#include <span>

#include "lab/world_light/vertex_light.h"

namespace temblor::lab {

struct WorldCorner {
  math::Vec3d at;
  PointLight light;
};

struct ScreenCorner {
  double x, y;
  std::array<double, kMaxChannels> light;  // times 1/z, if it is interpolated in perspective
};

struct LitPolygon {
  std::span<const ScreenCorner> corners;
  double top, bottom;      // the smallest and largest y
  PointLight least, most;  // of its light
};

// A channel's light at a pixel, and its change to the next one.
struct LightStep {
  double first, step;
};

// Light between the two edges that a row crosses.
struct RowLight {
  double left, right;  // x
  std::array<double, kMaxChannels> light_left, light_right;

  LightStep steps_from(double x, std::size_t channel) const {
    const double width = right - left;
    const double step = width > 1e-6 ? (light_right[channel] - light_left[channel]) / width : 0;
    return {light_left[channel] + step * (x - left), step};
  }
};

// The polygon on the screen; without corners if nothing of it is in the frustum. `over_z`: for light that is
// linear on the face. Otherwise light is linear on the screen. Lives in `arena`.
LitPolygon place_polygon(const render::ViewFrame& view, std::span<const WorldCorner> corners, bool over_z,
                         base::Arena& arena);

// The row nearest to `y` that the polygon covers. It must have corners.
RowLight cross_row(const LitPolygon& polygon, double y);

}  // namespace temblor::lab
