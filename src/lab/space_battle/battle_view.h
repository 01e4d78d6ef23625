// The view of the space battle.
//
//       up (y)  forward (z)
//         |  /                     A point (x, y, z) of view space is drawn at
//         | /                        center_x + x * pixels_per_unit / z,
//        eye ---- right (x)          center_y - y * pixels_per_unit / z
#pragma once

#include "math/angles.h"
#include "math/vec.h"

namespace temblor::lab::space {

struct BattleView {
  int width = 0, height = 0;
  math::Vec3d eye{0.0};
  math::Basis axes;
  double pixels_per_unit = 0;  // at distance 1
  double center_x = 0, center_y = 0;
  // Nothing nearer is drawn, because coordinates on the screen grow without bound toward the eye.
  double near_z = 0.05;

  // A direction, without the eye's place.
  math::Vec3d turn_to_view(const math::Vec3d& world) const {
    return {glm::dot(world, axes.right), glm::dot(world, axes.up), glm::dot(world, axes.forward)};
  }
  // Requires view.z > 0. Pixel centers are at whole numbers.
  math::Vec2d to_screen(const math::Vec3d& view) const {
    const double scale = pixels_per_unit / view.z;
    return {center_x + view.x * scale, center_y - view.y * scale};
  }
  // Whether a part of the ball may be on the screen.
  bool can_see(const math::Vec3d& center_view, double radius) const;
};

// `fov_deg` is the angle between the left and the right border of a 4:3 picture; a wider one shows more at
// its sides.
BattleView make_battle_view(const math::Vec3d& eye, const math::Basis& axes, double fov_deg, int width,
                            int height);

}  // namespace temblor::lab::space
