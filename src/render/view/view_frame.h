// Stage 1. Camera -> ViewFrame: the projection, and the planes of the frustum.
//
//       up (y)  forward (z)
//         |  /                     A point (x, y, z) of view space is drawn at
//         | /                        center_x + x * pixels_per_unit / z,
//        eye ---- right (x)          center_y - y * pixels_per_unit / z
//
// A polygon's 1/z and its texture coordinates over z are linear functions of the screen position. ScreenPlane
// holds such a function; the edge scan sorts by it and the span kernels interpolate with it. The derivation
// from the plane equation is Abrash's ("Consider the Alternatives: Quake's Hidden-Surface Removal"; "Graphics
// Programming Black Book", chapter 66).
#pragma once

#include <array>
#include <cstdint>

#include "math/angles.h"
#include "math/vec.h"
#include "render/scene.h"

namespace temblor::render {

// The distance of the near plane along the view, in units. Nearer geometry is clipped.
constexpr double kNearPlane = 1.0 / 16.0;

// A face is not drawn when the eye is nearer than this to its plane (orthographic: when the cosine of
// facing() is smaller): it would be a line on the screen, and its depth plane would be degenerate.
constexpr double kEdgeOn = 1e-6;

// A function of the pixel position that is linear in x and y: 1/z and texture coordinates over z are such
// functions on a plane.
struct ScreenPlane {
  double at_origin = 0, dx = 0, dy = 0;
  double at(double x, double y) const { return at_origin + dx * x + dy * y; }
};

// Inside: normal . p + offset >= 0. World space; the normal has any length.
struct FrustumPlane {
  math::Vec3d normal;
  double offset;
};

enum ClipFlags : std::uint8_t {
  kClipLeft = 1,
  kClipRight = 2,
  kClipTop = 4,
  kClipBottom = 8,
  kClipNear = 16,
  kClipAll = 31
};

// View space: x right, y up, z forward, in units. Screen space: pixel centers at whole numbers, y down.
struct ViewFrame {
  int width = 0, height = 0;
  bool perspective = true;
  math::Vec3d eye_world{0.0};
  math::Basis axes;
  // Perspective: at distance 1. Orthographic: everywhere.
  double pixels_per_unit = 0;
  double center_x = 0, center_y = 0;
  // The view model's focal length in pixels. It is always drawn in perspective.
  double weapon_pixels_per_unit = 0;
  double near_z = kNearPlane;
  // In the order of ClipFlags. There is no far plane.
  std::array<FrustumPlane, 5> frustum;
  world::LeafIndex eye_leaf{};

  math::Vec3d to_view(const math::Vec3d& world) const {
    const math::Vec3d d = world - eye_world;
    return {glm::dot(d, axes.right), glm::dot(d, axes.up), glm::dot(d, axes.forward)};
  }
  // Requires z >= near_z.
  math::Vec2d to_screen(const math::Vec3d& view) const {
    const double scale = perspective ? pixels_per_unit / view.z : pixels_per_unit;
    return {center_x + view.x * scale, center_y - view.y * scale};
  }
  // A measure that increases with nearness and is linear on the screen: 1/z, or minus the distance.
  double depth(double view_z) const { return perspective ? 1.0 / view_z : -view_z; }
};

// Clamps fields of view to 10 to 170 degrees. `width` and `height` are the frame's, at least 1.
ViewFrame make_view_frame(const Scene& scene, int width, int height);

// ViewFrame::depth, at each pixel, of the plane normal . p = distance (world space). The plane must not
// contain the eye (orthographic: must not be parallel to the view direction); see kEdgeOn.
ScreenPlane depth_plane(const ViewFrame& view, const math::Vec3d& normal, double distance);

// The function f(p) = axis . p + offset on the plane that `depth` belongs to, at each pixel. In perspective
// the result is f / z, and drawing divides it by 1/z.
ScreenPlane coordinate_plane(const ViewFrame& view, const ScreenPlane& depth, const math::Vec3d& axis,
                             double offset);

}  // namespace temblor::render
