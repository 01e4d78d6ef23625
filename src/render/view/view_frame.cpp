#include "render/view/view_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/visibility.h"

namespace temblor::render {

namespace {

// The focal length in pixels. A 4:3 picture has the requested field of view. A wider picture keeps its
// vertical angle and a narrower one its horizontal angle.
double perspective_scale(double fov_deg, int width, int height) {
  const double half_angle = std::clamp(fov_deg, 10.0, 170.0) * std::numbers::pi / 360.0;
  const double reference_width = std::min<double>(width, height * 4.0 / 3.0);
  return reference_width / 2 / std::tan(half_angle);
}

// Pixels per unit at which the world's bounds fit the picture with a margin of one twentieth.
double fitting_scale(const world::Level& level, const math::Basis& axes, int width, int height) {
  const math::Bounds& bounds = level.world().bounds;
  const math::Vec3d size = math::Vec3d(bounds.maxs) - math::Vec3d(bounds.mins);
  const double across = glm::dot(glm::abs(axes.right), size), along = glm::dot(glm::abs(axes.up), size);
  return std::min(width / std::max(across, 1.0), height / std::max(along, 1.0)) * 0.95;
}

}  // namespace

ViewFrame make_view_frame(const Scene& scene, int width, int height) {
  const Camera& camera = scene.camera;
  ViewFrame view;
  view.width = width;
  view.height = height;
  view.perspective = camera.projection == Projection::kPerspective;
  view.eye_world = math::Vec3d(camera.origin_world);
  view.axes = math::basis_from_angles(camera.angles_deg);
  view.center_x = width / 2.0 - 0.5;
  view.center_y = height / 2.0 - 0.5;
  if (view.perspective)
    view.pixels_per_unit = perspective_scale(camera.fov_deg, width, height);
  else
    view.pixels_per_unit = camera.units_per_pixel > 0 ? 1.0 / camera.units_per_pixel
                                                      : fitting_scale(*scene.level, view.axes, width, height);
  const float weapon_fov_deg = scene.weapon_fov_deg > 0 ? scene.weapon_fov_deg : camera.fov_deg;
  view.weapon_pixels_per_unit = perspective_scale(weapon_fov_deg, width, height);
  view.eye_leaf = world::find_leaf(*scene.level, camera.origin_world);

  // One pixel of slack around the picture: a node is culled only when it cannot cover the center of any
  // pixel. In perspective a side plane contains the eye, and its slack grows with distance; in parallel
  // projection the slack is a constant offset.
  const auto side = [&](const math::Vec3d& inward, double slack_px) {
    const math::Vec3d normal =
        inward * view.pixels_per_unit + (view.perspective ? view.axes.forward * slack_px : math::Vec3d(0.0));
    return FrustumPlane{normal, (view.perspective ? 0.0 : slack_px) - glm::dot(normal, view.eye_world)};
  };
  view.frustum[0] = side(view.axes.right, view.center_x + 1);
  view.frustum[1] = side(-view.axes.right, width - view.center_x);
  view.frustum[2] = side(-view.axes.up, view.center_y + 1);
  view.frustum[3] = side(view.axes.up, height - view.center_y);
  view.frustum[4] = {view.axes.forward, -view.near_z - glm::dot(view.axes.forward, view.eye_world)};
  return view;
}

ScreenPlane depth_plane(const ViewFrame& view, const math::Vec3d& normal, double distance) {
  const math::Vec3d n{glm::dot(normal, view.axes.right), glm::dot(normal, view.axes.up),
                      glm::dot(normal, view.axes.forward)};
  const double d = distance - glm::dot(normal, view.eye_world);
  ScreenPlane plane;
  if (view.perspective) {
    // n . (z * ray) = d, so 1/z = n . ray / d.
    const double scale = 1.0 / (view.pixels_per_unit * d);
    plane.dx = n.x * scale;
    plane.dy = -n.y * scale;
    plane.at_origin = n.z / d;
  } else {
    // n.x x + n.y y + n.z z = d, so -z = (n.x x + n.y y - d) / n.z.
    plane.dx = n.x / (view.pixels_per_unit * n.z);
    plane.dy = -n.y / (view.pixels_per_unit * n.z);
    plane.at_origin = -d / n.z;
  }
  plane.at_origin -= plane.dx * view.center_x + plane.dy * view.center_y;
  return plane;
}

ScreenPlane coordinate_plane(const ViewFrame& view, const ScreenPlane& depth, const math::Vec3d& axis,
                             double offset) {
  const math::Vec3d a{glm::dot(axis, view.axes.right), glm::dot(axis, view.axes.up),
                      glm::dot(axis, view.axes.forward)};
  const double at_eye = glm::dot(axis, view.eye_world) + offset;
  ScreenPlane along_ray;
  along_ray.dx = a.x / view.pixels_per_unit;
  along_ray.dy = -a.y / view.pixels_per_unit;
  if (view.perspective) {
    // f(eye + z ray) / z = axis . ray + f(eye) / z.
    along_ray.at_origin = a.z - along_ray.dx * view.center_x - along_ray.dy * view.center_y;
    return {along_ray.at_origin + at_eye * depth.at_origin, along_ray.dx + at_eye * depth.dx,
            along_ray.dy + at_eye * depth.dy};
  }
  // f = f(eye) + a.x x + a.y y + a.z z, with z = -depth.
  along_ray.at_origin = at_eye - along_ray.dx * view.center_x - along_ray.dy * view.center_y;
  return {along_ray.at_origin - a.z * depth.at_origin, along_ray.dx - a.z * depth.dx,
          along_ray.dy - a.z * depth.dy};
}

}  // namespace temblor::render
