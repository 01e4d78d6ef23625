// Projection: from a place in space, seen from the origin along z, to a place in the picture.
#pragma once

#include <cmath>

#include "lab/school/interpolation.h"
#include "lab/school/space.h"

namespace temblor::lab::school {

struct View {
  float width, height;  // of the picture, in pixels
  // The angle between the top and the bottom of the picture. A wider picture shows more at its sides.
  float field_of_view_deg = 60;
  float near = 0.1f;  // the distance of the near plane; nothing nearer is drawn
};

// Depth has no effect. `units` of space fill the height of the picture.
inline Point project_parallel(const Vector& place, const View& view, float units) {
  const float pixels_per_unit = view.height / units;
  return {view.width / 2 + place.x * pixels_per_unit, view.height / 2 - place.y * pixels_per_unit};
}

// The distance at which the picture stands before the eye, if it is 2 high: half of it is seen at half of the
// field of view.
inline float find_picture_distance(const View& view) {
  constexpr float kPi = 3.14159265f;
  return 1 / std::tan(view.field_of_view_deg / 2 * kPi / 180);
}

// Similar triangles: at twice the depth, everything is half as far from the center. Depth must be above 0,
// which clipping to the near plane ensures.
inline Point project_perspective(const Vector& place, const View& view) {
  const float distance = find_picture_distance(view);
  const float aspect = view.width / view.height;
  const float x = distance / aspect * place.x / place.z;  // -1 to 1 in the picture
  const float y = distance * place.y / place.z;
  return {(1 + x) * view.width / 2, (1 - y) * view.height / 2};
}

}  // namespace temblor::lab::school
