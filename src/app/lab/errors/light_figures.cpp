#include "app/lab/errors/light_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace temblor::app {
namespace {

// The brightest gray that stays below 256 in full light. A step changes it by about 4.
constexpr std::uint8_t kGray = 127;
constexpr double kLevelsPerStep = kGray / 32.0;

// Changes of the engine's light from one pixel to the next: up to the first, light is even; from the second
// on, it is the edge of a shadow.
constexpr double kEvenStep = 1, kEdgeStep = 2;

double pixel_light(std::uint32_t color) {
  return (color & 255) / kLevelsPerStep;
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
  const std::vector<LitPoint> points = choose_lit_points(scene.camera);
  follow(points, scene, settings, {0, kTurnStep_deg, 0}, figures_.turn);
  follow(points, scene, settings, {0, 0, kTurnStep_deg}, figures_.roll);
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
  const auto square = find_square(pixel, face, frame_.width(), frame_.height(), faces_);
  if (!square) return std::nullopt;
  const auto width = static_cast<std::size_t>(frame_.width());
  std::array<double, 4> lights{};
  for (std::size_t i = 0; i < lights.size(); ++i)
    lights[i] = pixel_light(frame_.rgb()[square->first + i / 2 * width + i % 2]);
  const auto [least, most] = std::ranges::minmax(lights);
  if (most - least > 1) return std::nullopt;
  return std::lerp(std::lerp(lights[0], lights[1], square->fraction.x),
                   std::lerp(lights[2], lights[3], square->fraction.x), square->fraction.y);
}

std::vector<LightViews::LitPoint> LightViews::choose_lit_points(const render::Camera& camera) const {
  std::vector<LitPoint> points;
  for (const ScreenPoint& point : choose_points(camera, right_, faces_))
    if (const std::optional<double> light = find_light(point.pixel, point.face))
      points.push_back({point, *light});
  return points;
}

void LightViews::follow(std::vector<LitPoint> points, const render::Scene& scene,
                        const render::Settings& settings, math::Vec3 step_deg, Differences& io_difference) {
  render::Scene turned = scene;
  for (int i = 0; i < kTurnSteps && !points.empty(); ++i) {
    turned.camera.angles_deg += step_deg;
    draw(turned, settings);
    std::vector<LitPoint> in_sight;
    for (auto [point, light] : points) {
      const auto pixel = find_pixel(turned.camera, point.at_world, frame_.width(), frame_.height());
      const std::optional<double> now = pixel ? find_light(*pixel, point.face) : std::nullopt;
      if (!now) continue;
      io_difference.add(*now - light);
      in_sight.push_back({point, *now});
    }
    points = std::move(in_sight);
  }
}

}  // namespace temblor::app
