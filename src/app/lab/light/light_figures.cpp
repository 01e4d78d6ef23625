#include "app/lab/light/light_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "oracle/comparison.h"

namespace temblor::app {
namespace {

// The brightest gray that stays below 256 in full light. A step changes it by about 4.
constexpr std::uint8_t kGray = 127;
constexpr double kLevelsPerStep = kGray / 32.0;

// Frames of a turn, and the angle between two.
constexpr int kFrames = 6;
constexpr float kStep_deg = 3;
constexpr std::size_t kPoints = 4000;

// Changes of the engine's light from one pixel to the next: up to the first, light is even; from the second
// on, it is the edge of a shadow.
constexpr double kEvenStep = 1, kEdgeStep = 2;

double pixel_light(std::uint32_t color) {
  return (color & 255) / kLevelsPerStep;
}

bool is_same(const render::PixelFace& a, const render::PixelFace& b) {
  return a.instance == b.instance && a.face == b.face;
}

// A position on the screen, by the projection that CameraRays defines.
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

}  // namespace

formats::Palette make_gray_palette() {
  formats::Palette palette;
  palette.fill({kGray, kGray, kGray});
  return palette;
}

formats::Colormap make_gray_colormap() {
  formats::Colormap colormap;
  colormap.fullbrights = 0;
  return colormap;
}

void LightDifference::add(double difference) {
  const double size = std::abs(difference);
  sum += size;
  largest = std::max(largest, size);
  ++count;
}

LightViews::LightViews(const lab::Choice& choice, int width, int height)
    : engine_(make_gray_palette(), make_gray_colormap()),
      technique_(make_gray_palette(), make_gray_colormap()),
      right_(width, height, render::PixelFormat::kRgb),
      frame_(width, height, render::PixelFormat::kRgb),
      faces_(frame_.pixel_count()),
      writes_(frame_.pixel_count()) {
  technique_.replace_stages(choice.make_stages());
}

void LightViews::draw(const render::Scene& scene, const render::Settings& settings) {
  technique_.render(scene, settings, frame_);
  technique_.pixel_faces(faces_, writes_);
}

void LightViews::add(const render::Scene& scene, const render::Settings& asked) {
  render::Settings settings = asked;
  settings.colored_light = false;
  engine_.render(scene, settings, right_);
  draw(scene, settings);
  compare_with_engine(*scene.level);
  if (scene.camera.projection != render::Projection::kPerspective) return;
  const std::vector<Point> points = choose_points(scene);
  follow(points, scene, settings, {0, kStep_deg, 0}, figures_.turn);
  follow(points, scene, settings, {0, 0, kStep_deg}, figures_.roll);
}

void LightViews::compare_with_engine(const world::Level& level) {
  const auto width = static_cast<std::size_t>(frame_.width());
  for (std::size_t i = 0; i < frame_.pixel_count(); ++i) {
    figures_.error.add(pixel_light(frame_.rgb()[i]) - pixel_light(right_.rgb()[i]));
    if ((i + 1) % width != 0) compare_neighbors(level, i, i + 1);
    if (i + width < frame_.pixel_count()) compare_neighbors(level, i, i + width);
  }
}

void LightViews::compare_neighbors(const world::Level& level, std::size_t pixel, std::size_t neighbor) {
  const render::PixelFace &a = faces_[pixel], &b = faces_[neighbor];
  if (a.instance == render::PixelFace::kNothing || a.instance != b.instance) return;
  const world::Face &face = level.faces[a.face], &next = level.faces[b.face];
  if (face.plane != next.plane || face.back_side != next.back_side) return;
  const double right = pixel_light(right_.rgb()[neighbor]) - pixel_light(right_.rgb()[pixel]);
  const double drawn = pixel_light(frame_.rgb()[neighbor]) - pixel_light(frame_.rgb()[pixel]);
  if (a.face != b.face && std::abs(right) <= kEvenStep)
    figures_.seams.add(drawn - right);
  else if (a.face == b.face && std::abs(right) >= kEdgeStep)
    figures_.shadow_edges.add(drawn - right);
}

// The light at a position on the screen that must show a face: interpolated between the four pixels around.
// Nothing if one of them shows another face, or if they differ by more than a step: between such pixels,
// light is unknown, for example far away, where a pixel is many texels wide.
std::optional<double> LightViews::find_light(math::Vec2d pixel, const render::PixelFace& face) const {
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= frame_.width() - 1 || pixel.y >= frame_.height() - 1)
    return std::nullopt;
  const auto width = static_cast<std::size_t>(frame_.width());
  const double x = std::floor(pixel.x), y = std::floor(pixel.y);
  const std::size_t first = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
  std::array<double, 4> lights{};
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::size_t at = first + i / 2 * width + i % 2;
    if (!is_same(faces_[at], face)) return std::nullopt;
    lights[i] = pixel_light(frame_.rgb()[at]);
  }
  const auto [least, most] = std::ranges::minmax(lights);
  if (most - least > 1) return std::nullopt;
  return std::lerp(std::lerp(lights[0], lights[1], pixel.x - x), std::lerp(lights[2], lights[3], pixel.x - x),
                   pixel.y - y);
}

// Points under pixels at equal distances in the order of rows, in all columns.
std::vector<LightViews::Point> LightViews::choose_points(const render::Scene& scene) const {
  const oracle::CameraRays rays(scene.camera, frame_.width(), frame_.height());
  const auto width = static_cast<std::size_t>(frame_.width());
  std::size_t step = std::max<std::size_t>(frame_.pixel_count() / kPoints, 1);
  while (std::gcd(step, width) != 1) ++step;
  std::vector<Point> points;
  for (std::size_t i = step / 2; i < frame_.pixel_count(); i += step) {
    const float nearness = right_.depth()[i];
    const auto x = static_cast<double>(i % width), y = static_cast<double>(i / width);
    if (faces_[i].instance == render::PixelFace::kNothing || !(nearness > 0)) continue;
    const std::optional<double> light = find_light({x, y}, faces_[i]);
    if (light) points.push_back({rays.ray(x, y).at(1.0 / nearness), faces_[i], *light});
  }
  return points;
}

void LightViews::follow(std::vector<Point> points, const render::Scene& scene,
                        const render::Settings& settings, math::Vec3 step_deg,
                        LightDifference& io_difference) {
  render::Scene turned = scene;
  for (int i = 0; i < kFrames && !points.empty(); ++i) {
    turned.camera.angles_deg += step_deg;
    draw(turned, settings);
    std::vector<Point> in_sight;
    for (Point point : points) {
      const auto pixel = find_pixel(turned.camera, point.at_world, frame_.width(), frame_.height());
      const std::optional<double> now = pixel ? find_light(*pixel, point.face) : std::nullopt;
      if (!now) continue;
      io_difference.add(*now - point.light);
      point.light = *now;
      in_sight.push_back(point);
    }
    points = std::move(in_sight);
  }
}

}  // namespace temblor::app
