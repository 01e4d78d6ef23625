#include "render/surfaces/choose_mip.h"

#include <algorithm>
#include <cmath>

namespace temblor::render {

// The width in pixels of a texel of mip 0, as stock Quake estimates it, and stock Quake's thresholds. Below
// mip 0, the width doubles from level to level.
int stock_mip(const ViewFrame& view, double nearest, double axes_length, int finest) {
  const double bias = axes_length < 0.32 ? 4 : axes_length < 0.49 ? 3 : axes_length < 0.99 ? 2 : 1;
  const double scale = view.pixels_per_unit * (view.perspective ? nearest : 1.0) * bias;
  if (scale < 1.0) return scale >= 0.4 ? 1 : scale >= 0.2 ? 2 : 3;
  int mip = 0;
  while (mip > finest && scale >= std::ldexp(1.0, 1 - mip)) --mip;
  return mip;
}

// The area in the texture that one pixel maps to is the determinant of the Jacobian. Each mip level has a
// quarter of the texels; the level whose texels are closest to one per pixel is chosen, so the thresholds are
// 2, 8, 32, and below mip 0 1/2, 1/8, 1/32.
int footprint_mip(const ViewFrame& view, const TexturePlanes& planes, double x, double y, int finest) {
  const auto& [depth, s, t] = planes;
  double texels = std::abs(s.dx * t.dy - s.dy * t.dx);
  if (view.perspective) {
    // The Jacobian of (s, t) / depth is the determinant of the three planes divided by depth cubed.
    const double determinant = s.at_origin * (t.dx * depth.dy - t.dy * depth.dx) -
                               s.dx * (t.at_origin * depth.dy - t.dy * depth.at_origin) +
                               s.dy * (t.at_origin * depth.dx - t.dx * depth.at_origin);
    const double here = depth.at(x, y);
    if (!(here > 0)) return 0;  // the face's corners are off its plane
    texels = std::abs(determinant) / (here * here * here);
  }
  if (texels >= 2) return texels < 8 ? 1 : texels < 32 ? 2 : 3;
  int mip = 0;
  while (mip > finest && texels < std::ldexp(0.5, 2 * mip)) --mip;
  return mip;
}

// Clips the polygon to the frustum (Sutherland and Hodgman) and takes the nearest of the remaining corners.
double nearest_depth(const ViewFrame& view, std::span<const math::Vec3d> corners_world, base::Arena& arena) {
  base::ArenaVector<math::Vec3d> inside(arena, corners_world.size() + 8),
      clipped(arena, corners_world.size() + 8);
  for (const math::Vec3d& corner : corners_world) inside.push_back(corner);
  for (const FrustumPlane& plane : view.frustum) {
    clipped.clear();
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const math::Vec3d &here = inside[i], &next = inside[(i + 1) % inside.size()];
      const double d_here = glm::dot(plane.normal, here) + plane.offset;
      const double d_next = glm::dot(plane.normal, next) + plane.offset;
      if (d_here >= 0) clipped.push_back(here);
      if ((d_here < 0) != (d_next < 0))
        clipped.push_back(here + (next - here) * (d_here / (d_here - d_next)));
    }
    std::swap(inside, clipped);
  }
  double nearest = view.depth(1e9);
  for (const math::Vec3d& corner : inside)
    nearest = std::max(nearest, view.depth(std::max(view.to_view(corner).z, view.near_z)));
  return nearest;
}

}  // namespace temblor::render
