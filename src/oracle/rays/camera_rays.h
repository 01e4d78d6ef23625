// The ray of a pixel, from the definitions of the two projections.
#pragma once

#include "math/angles.h"
#include "math/vec.h"
#include "render/scene.h"

namespace temblor::oracle {

// `direction` has length 1 along the view's forward axis, so a distance in multiples of it is the depth z.
struct Ray {
  math::Vec3d origin{0.0};
  math::Vec3d direction{1, 0, 0};

  math::Vec3d at(double distance) const { return origin + direction * distance; }
};

// Pixel centers are at integer coordinates, the center of projection at (width / 2 - 0.5, height / 2 - 0.5).
class CameraRays {
 public:
  // An orthographic camera must set units_per_pixel: how the level is fitted is up to the renderer.
  CameraRays(const render::Camera& camera, int width, int height);

  // Any real position, including between pixels and outside the picture.
  Ray ray(double x_px, double y_px) const;

 private:
  render::Projection projection_;
  math::Vec3d origin_;
  math::Basis basis_;
  double center_x_px_, center_y_px_;
  double slope_per_pixel_;  // perspective: 1 / focal length; orthographic: units per pixel
};

}  // namespace temblor::oracle
