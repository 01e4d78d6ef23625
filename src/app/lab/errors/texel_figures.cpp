#include "app/lab/errors/texel_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/comparison.h"

namespace temblor::app {

namespace {

// Positions repeat after this many texels, so that both fit into a palette index.
constexpr int kPeriod = 16;

// Each row shows an index as itself.
formats::Colormap make_even_colormap() {
  formats::Colormap colormap;
  for (std::size_t i = 0; i < colormap.rows.size(); ++i)
    colormap.rows[i] = static_cast<std::uint8_t>(i % 256);
  colormap.fullbrights = 0;
  return colormap;
}

formats::Palette make_gray_ramp() {
  formats::Palette palette;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const auto gray = static_cast<std::uint8_t>(i);
    palette[i] = {gray, gray, gray};
  }
  return palette;
}

bool repeats_evenly(const world::Texture& texture) {
  return texture.width % kPeriod == 0 && texture.height % kPeriod == 0;
}

// Sky and liquids move by themselves.
bool shows_positions(const world::Level& level, const world::Face& face) {
  return face.kind == world::FaceKind::kLit && repeats_evenly(level.texture(face.texture));
}

void show_positions(world::Texture& io_texture) {
  io_texture.colors = nullptr;
  // Holes would hide a position.
  if (io_texture.kind == world::TextureKind::kCutout) io_texture.kind = world::TextureKind::kOpaque;
  std::vector<std::uint8_t>& texels = io_texture.mips[0];
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const std::size_t s = i % io_texture.width, t = i / io_texture.width;
    texels[i] = static_cast<std::uint8_t>(s % kPeriod * kPeriod + t % kPeriod);
  }
}

// The shortest way between two positions that repeat.
double wrap(double difference) {
  return difference - kPeriod * std::round(difference / kPeriod);
}

double find_larger(math::Vec2d shift) {
  return std::max(std::abs(shift.x), std::abs(shift.y));
}

math::Vec3d find_point(const world::Plane& plane, const oracle::Ray& ray) {
  const math::Vec3d normal(plane.normal);
  return ray.at((static_cast<double>(plane.distance) - glm::dot(normal, ray.origin)) /
                glm::dot(normal, ray.direction));
}

}  // namespace

TexelViews::TexelViews(const lab::Choice& choice, int width, int height)
    : renderer_(make_gray_ramp(), make_even_colormap()),
      frame_(width, height, render::PixelFormat::kIndexed),
      faces_(frame_.pixel_count()),
      writes_(frame_.pixel_count()) {
  renderer_.replace_stages(choice.make_stages());
}

void TexelViews::use_level(const world::Level& level) {
  if (original_ == level.identity) return;
  original_ = level.identity;
  level_ = level;
  level_.identity = std::make_shared<const world::LevelIdentity>();
  for (world::Texture& texture : level_.textures) show_positions(texture);
}

void TexelViews::draw(const render::Scene& scene, const render::Settings& settings) {
  renderer_.render(scene, settings, frame_);
  renderer_.pixel_faces(faces_, writes_);
}

void TexelViews::add(const render::Scene& scene, const render::Settings& settings) {
  if (scene.camera.projection != render::Projection::kPerspective) return;
  use_level(*scene.level);
  render::Scene shown = scene;
  shown.level = &level_;
  draw(shown, settings);
  std::vector<TexelPoint> points;
  for (const ScreenPoint& point : choose_points(shown.camera, frame_, faces_)) {
    if (point.face.instance != 0 || !shows_positions(level_, level_.faces[point.face.face])) continue;
    const std::size_t pixel =
        static_cast<std::size_t>(point.pixel.y) * static_cast<std::size_t>(frame_.width()) +
        static_cast<std::size_t>(point.pixel.x);
    figures_.error.add(std::max(find_larger(find_shift(shown.camera, pixel)) - 0.5, 0.0));
    if (const auto shift = find_mean_shift(shown.camera, point.pixel, point.face))
      points.push_back({point, *shift});
  }
  follow(points, shown, settings, {0, kTurnStep_deg, 0}, figures_.turn);
  follow(std::move(points), shown, settings, {0, 0, kTurnStep_deg}, figures_.roll);
}

// From the exact position at a pixel's center to the center of the texel that it shows.
math::Vec2d TexelViews::find_shift(const render::Camera& camera, std::size_t pixel) const {
  const world::Face& face = level_.faces[faces_[pixel].face];
  const auto width = static_cast<std::size_t>(frame_.width());
  const oracle::Ray ray = oracle::CameraRays(camera, frame_.width(), frame_.height())
                              .ray(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
  const math::Vec3d at = find_point(level_.planes[face.plane], ray);
  const world::TextureAxes& axes = level_.texture_axes[face.axes];
  const std::uint8_t shown = frame_.indexed()[pixel];
  const double s = glm::dot(math::Vec3d(axes.s_axis), at) + static_cast<double>(axes.s_offset);
  const double t = glm::dot(math::Vec3d(axes.t_axis), at) + static_cast<double>(axes.t_offset);
  return {wrap(shown / kPeriod + 0.5 - s), wrap(shown % kPeriod + 0.5 - t)};
}

std::optional<math::Vec2d> TexelViews::find_mean_shift(const render::Camera& camera, math::Vec2d pixel,
                                                       const render::PixelFace& face) const {
  const auto square = find_square(pixel, face, frame_.width(), frame_.height(), faces_);
  if (!square) return std::nullopt;
  const auto width = static_cast<std::size_t>(frame_.width());
  const auto [x, y] = std::pair(square->fraction.x, square->fraction.y);
  const math::Vec2d above =
      glm::mix(find_shift(camera, square->first), find_shift(camera, square->first + 1), x);
  const math::Vec2d below =
      glm::mix(find_shift(camera, square->first + width), find_shift(camera, square->first + width + 1), x);
  return glm::mix(above, below, y);
}

void TexelViews::follow(std::vector<TexelPoint> points, const render::Scene& scene,
                        const render::Settings& settings, math::Vec3 step_deg, Differences& io_difference) {
  render::Scene turned = scene;
  for (int i = 0; i < kTurnSteps && !points.empty(); ++i) {
    turned.camera.angles_deg += step_deg;
    draw(turned, settings);
    std::vector<TexelPoint> in_sight;
    for (const auto& [point, before] : points) {
      const auto pixel = find_pixel(turned.camera, point.at_world, frame_.width(), frame_.height());
      const auto now = pixel ? find_mean_shift(turned.camera, *pixel, point.face) : std::nullopt;
      if (!now) continue;
      io_difference.add(find_larger({wrap(now->x - before.x), wrap(now->y - before.y)}));
      in_sight.push_back({point, *now});
    }
    points = std::move(in_sight);
  }
}

}  // namespace temblor::app
