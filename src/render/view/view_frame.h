// Stage 1. Camera -> ViewFrame: the projection and the planes that bound what it can show.
#pragma once

#include <array>
#include <cstdint>

#include "math/angles.h"
#include "math/vec.h"
#include "render/scene.h"

namespace temblor::render {

// Nothing nearer than this is drawn, in units along the view.
constexpr double kNearPlane = 1.0 / 16.0;

// A plane that the eye is nearer to than this (seen in parallel: a cosine) is a line on the screen: its faces
// are not drawn.
constexpr double kEdgeOn = 1e-6;

// A function of the pixel, linear in x and y: 1/z and texture coordinates over z are such functions on a
// plane.
struct ScreenPlane {
  double at_origin = 0, dx = 0, dy = 0;
  double at(double x, double y) const { return at_origin + dx * x + dy * y; }
};

// normal . p + offset >= 0 inside. World space.
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

// View space: x right, y up, z forward, units. Screen space: pixel centers at whole numbers, y down.
struct ViewFrame {
  int width = 0, height = 0;
  bool perspective = true;
  math::Vec3d eye_world{0.0};
  math::Basis axes;
  double pixels_per_unit = 0;  // perspective: at distance 1; orthographic: anywhere
  double center_x = 0, center_y = 0;
  double near_z = kNearPlane;
  std::array<FrustumPlane, 5> frustum;  // in the order of ClipFlags
  world::LeafIndex eye_leaf{};

  math::Vec3d to_view(const math::Vec3d& world) const {
    const math::Vec3d d = world - eye_world;
    return {glm::dot(d, axes.right), glm::dot(d, axes.up), glm::dot(d, axes.forward)};
  }
  // z >= near_z.
  math::Vec2d to_screen(const math::Vec3d& view) const {
    const double scale = perspective ? pixels_per_unit / view.z : pixels_per_unit;
    return {center_x + view.x * scale, center_y - view.y * scale};
  }
  // What increases with nearness and is linear on the screen: 1/z, or minus the distance.
  double depth(double view_z) const { return perspective ? 1.0 / view_z : -view_z; }
};

ViewFrame make_view_frame(const Scene& scene, int width, int height);

// On the plane normal . p = distance (world space), what ViewFrame::depth is at each pixel. The plane does
// not pass through the eye, or (orthographic) lie along the view.
ScreenPlane depth_plane(const ViewFrame& view, const math::Vec3d& normal, double distance);

// On a plane with that depth plane: f(p) = axis . p + offset, times 1/z in perspective, at each pixel.
ScreenPlane coordinate_plane(const ViewFrame& view, const ScreenPlane& depth, const math::Vec3d& axis,
                             double offset);

}  // namespace temblor::render
