#include "support/pictures/view_by_hand.h"

#include <algorithm>
#include <cmath>

namespace temblor::test {

render::ViewFrame make_test_view(int width, int height, double fov_deg, const math::Vec3& angles_deg,
                                 const math::Vec3d& eye_world) {
  render::ViewFrame view;
  view.width = width;
  view.height = height;
  view.eye_world = eye_world;
  view.axes = math::basis_from_angles(angles_deg);
  view.pixels_per_unit = std::min(width * 1.0, height * 4.0 / 3) / 2 / std::tan(fov_deg * M_PI / 360);
  view.center_x = width / 2.0 - 0.5;
  view.center_y = height / 2.0 - 0.5;
  return view;
}

}  // namespace temblor::test
