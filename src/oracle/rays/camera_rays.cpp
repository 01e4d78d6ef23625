#include "oracle/rays/camera_rays.h"

#include <cmath>
#include <numbers>

#include "base/check.h"

namespace temblor::oracle {
namespace {

// The field of view spans the largest 4:3 rectangle in a picture: of full height in wider pictures, of full
// width in narrower ones.
double focal_length_px(double fov_deg, int width, int height) {
  const double half_angle = fov_deg * std::numbers::pi / 360.0;
  const bool wide = width * 3 >= height * 4;
  const double half_width_of_4_to_3_px = (wide ? height * 4.0 / 3.0 : width) / 2.0;
  return half_width_of_4_to_3_px / std::tan(half_angle);
}

}  // namespace

CameraRays::CameraRays(const render::Camera& camera, int width, int height)
    : projection_(camera.projection),
      origin_(camera.origin_world),
      basis_(math::basis_from_angles(camera.angles_deg)),
      center_x_px_(width / 2.0 - 0.5),
      center_y_px_(height / 2.0 - 0.5) {
  if (projection_ == render::Projection::kPerspective) {
    slope_per_pixel_ = 1.0 / focal_length_px(camera.fov_deg, width, height);
  } else {
    CHECK(camera.units_per_pixel > 0);
    slope_per_pixel_ = camera.units_per_pixel;
  }
}

Ray CameraRays::ray(double x_px, double y_px) const {
  const math::Vec3d aside = basis_.right * ((x_px - center_x_px_) * slope_per_pixel_) -
                            basis_.up * ((y_px - center_y_px_) * slope_per_pixel_);
  if (projection_ == render::Projection::kPerspective) return {origin_, basis_.forward + aside};
  return {origin_ + aside, basis_.forward};
}

}  // namespace temblor::oracle
