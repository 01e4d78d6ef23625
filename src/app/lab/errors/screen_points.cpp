#include "app/lab/errors/screen_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oracle/comparison.h"

namespace temblor::app {

namespace {

constexpr std::size_t kPoints = 4000;

}  // namespace

bool is_same_face(const render::PixelFace& a, const render::PixelFace& b) {
  return a.instance == b.instance && a.face == b.face;
}

std::optional<math::Vec2d> find_pixel(const render::Camera& camera, const math::Vec3d& at_world, int width,
                                      int height) {
  const oracle::CameraRays rays(camera, width, height);
  const double middle_x = width / 2.0 - 0.5, middle_y = height / 2.0 - 0.5;
  const math::Vec3d forward = rays.ray(middle_x, middle_y).direction;
  const math::Vec3d right = rays.ray(middle_x + 1, middle_y).direction - forward;
  const math::Vec3d down = rays.ray(middle_x, middle_y + 1).direction - forward;
  const math::Vec3d from_eye = at_world - math::Vec3d(camera.origin_world);
  const double z = glm::dot(from_eye, forward);
  if (z <= 0) return std::nullopt;
  return math::Vec2d(middle_x + glm::dot(from_eye, right) / z / glm::dot(right, right),
                     middle_y + glm::dot(from_eye, down) / z / glm::dot(down, down));
}

std::vector<ScreenPoint> choose_points(const render::Camera& camera, const render::FrameBuffer& frame,
                                       std::span<const render::PixelFace> faces) {
  const oracle::CameraRays rays(camera, frame.width(), frame.height());
  const auto width = static_cast<std::size_t>(frame.width());
  std::size_t step = std::max<std::size_t>(frame.pixel_count() / kPoints, 1);
  while (std::gcd(step, width) != 1) ++step;
  std::vector<ScreenPoint> points;
  for (std::size_t i = step / 2; i < frame.pixel_count(); i += step) {
    const float nearness = frame.depth()[i];
    if (faces[i].instance == render::PixelFace::kNothing || !(nearness > 0)) continue;
    const math::Vec2d pixel(i % width, i / width);
    points.push_back({rays.ray(pixel.x, pixel.y).at(1.0 / nearness), faces[i], pixel});
  }
  return points;
}

std::optional<PixelSquare> find_square(math::Vec2d pixel, const render::PixelFace& face, int width,
                                       int height, std::span<const render::PixelFace> faces) {
  if (!(pixel.x >= 0 && pixel.y >= 0 && pixel.x < width - 1 && pixel.y < height - 1)) return std::nullopt;
  const double x = std::floor(pixel.x), y = std::floor(pixel.y);
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t first = static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x);
  for (const std::size_t at : {first, first + 1, first + columns, first + columns + 1})
    if (!is_same_face(faces[at], face)) return std::nullopt;
  return PixelSquare{first, {pixel.x - x, pixel.y - y}};
}

}  // namespace temblor::app
