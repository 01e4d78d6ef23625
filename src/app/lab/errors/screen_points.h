// Points of the world that are followed over the screen while the camera moves.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/frame_buffer.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace temblor::app {

// Steps of a turn or a roll, and the angle of each.
constexpr int kTurnSteps = 6;
constexpr float kTurnStep_deg = 3;

// A point of the world, and the face that shows it.
struct ScreenPoint {
  math::Vec3d at_world;
  render::PixelFace face;
  math::Vec2d pixel;  // where it is on the screen
};

bool is_same_face(const render::PixelFace& a, const render::PixelFace& b);

// The position of a point on the screen, by the projection that oracle::CameraRays defines. Nothing if it is
// behind the eye.
std::optional<math::Vec2d> find_pixel(const render::Camera& camera, const math::Vec3d& at_world, int width,
                                      int height);

// Some thousand points of faces, under pixels at equal distances in the order of rows and in all columns.
// `faces`: those that `frame` shows.
std::vector<ScreenPoint> choose_points(const render::Camera& camera, const render::FrameBuffer& frame,
                                       std::span<const render::PixelFace> faces);

// The four pixels around a position, if all of them show `face`.
struct PixelSquare {
  std::size_t first;     // the upper left one
  math::Vec2d fraction;  // from it to the position
};
std::optional<PixelSquare> find_square(math::Vec2d pixel, const render::PixelFace& face, int width,
                                       int height, std::span<const render::PixelFace> faces);

}  // namespace temblor::app
