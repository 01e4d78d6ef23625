#include "lab/space_battle/battle_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace temblor::lab::space {

BattleView make_battle_view(const math::Vec3d& eye, const math::Basis& axes, double fov_deg, int width,
                            int height) {
  BattleView view;
  view.width = width;
  view.height = height;
  view.eye = eye;
  view.axes = axes;
  const double width_4_3 = std::min<double>(width, height * 4.0 / 3.0);
  view.pixels_per_unit = width_4_3 / 2 / std::tan(fov_deg * std::numbers::pi / 360);
  view.center_x = width / 2.0 - 0.5;
  view.center_y = height / 2.0 - 0.5;
  return view;
}

// The screen's borders are planes through the eye. Beside one of them, a point is farther from the plane in
// the middle of the screen: |x| * pixels_per_unit > z * width / 2.
bool BattleView::can_see(const math::Vec3d& center_view, double radius) const {
  const auto is_beside = [&](double across, double half_size_px) {
    const double outside = std::abs(across) * pixels_per_unit - center_view.z * half_size_px;
    return outside > radius * std::sqrt(pixels_per_unit * pixels_per_unit + half_size_px * half_size_px);
  };
  return center_view.z + radius >= near_z && !is_beside(center_view.x, width / 2.0) &&
         !is_beside(center_view.y, height / 2.0);
}

}  // namespace temblor::lab::space
