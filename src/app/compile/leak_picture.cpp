#include "app/compile/leak_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "formats/images/png.h"

namespace temblor::app {
namespace {

using math::Vec2d;
using math::Vec3d;

constexpr int kWidthPx = 1200, kMarginPx = 24, kMaxHeightPx = 1600;

// Components from 0 to 1.
struct Color {
  float red = 0, green = 0, blue = 0;
};
constexpr Color kBackground{0.07f, 0.08f, 0.10f}, kWall{0.75f, 0.80f, 0.90f}, kPath{1.0f, 0.55f, 0.10f},
    kStart{0.25f, 0.90f, 0.35f}, kEnd{1.0f, 0.20f, 0.20f};

// A picture with antialiased dots and lines. Drawing outside of it is allowed and has no effect.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kBackground) {}

  int width() const { return width_; }
  int height() const { return height_; }

  // Draws a disc whose rim fades over one pixel.
  void dot(const Vec2d& center_px, double radius_px, const Color& color, float opacity) {
    const auto first = [](double place) { return static_cast<int>(std::floor(place)); };
    for (int y = first(center_px.y - radius_px); y <= first(center_px.y + radius_px) + 1; ++y)
      for (int x = first(center_px.x - radius_px); x <= first(center_px.x + radius_px) + 1; ++x) {
        const double away = std::hypot(x + 0.5 - center_px.x, y + 0.5 - center_px.y);
        mix(x, y, color, opacity * static_cast<float>(std::clamp(radius_px + 0.5 - away, 0.0, 1.0)));
      }
  }

  // Draws a line as overlapping dots, half a pixel apart. Slow but simple; a picture takes a fraction of a
  // second.
  void line(const Vec2d& from_px, const Vec2d& to_px, double radius_px, const Color& color, float opacity) {
    constexpr double kStepPx = 0.5;
    const auto steps = std::max(1, static_cast<int>(glm::length(to_px - from_px) / kStepPx));
    for (int i = 0; i <= steps; ++i)
      dot(from_px + (to_px - from_px) * (double(i) / steps), radius_px, color, opacity);
  }

  base::Result<base::ByteVector> png() const {
    std::vector<std::uint32_t> rgb;
    const auto byte = [](float part) { return static_cast<std::uint32_t>(std::lround(part * 255)); };
    for (const Color& pixel : pixels_)
      rgb.push_back(byte(pixel.red) << 16 | byte(pixel.green) << 8 | byte(pixel.blue));
    return formats::write_png(rgb, width_, height_);
  }

 private:
  void mix(int x, int y, const Color& color, float share) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    Color& pixel =
        pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    pixel.red += (color.red - pixel.red) * share;
    pixel.green += (color.green - pixel.green) * share;
    pixel.blue += (color.blue - pixel.blue) * share;
  }

  int width_, height_;
  std::vector<Color> pixels_;
};

struct Bounds {
  Vec3d mins{std::numeric_limits<double>::max()}, maxs{std::numeric_limits<double>::lowest()};

  void add(const Vec3d& point) {
    mins = glm::min(mins, point);
    maxs = glm::max(maxs, point);
  }
};

// One orthographic view: the x axis to the right, `up_axis` upward.
struct Projection {
  // The level's point at the lower left corner.
  Vec3d mins;
  int up_axis;
  double px_per_unit;
  Vec2d lower_left_px;

  Vec2d operator()(const Vec3d& point) const {
    return {lower_left_px.x + (point.x - mins.x) * px_per_unit,
            lower_left_px.y - (point[up_axis] - mins[up_axis]) * px_per_unit};
  }
};

using Edge = std::array<Vec3d, 2>;

// Returns the edges of all faces of the world, without brush models. Edges that faces share appear twice.
std::vector<Edge> list_world_edges(const formats::Bsp& bsp) {
  std::vector<Edge> edges;
  const formats::BspModel& world = bsp.models.front();
  for (std::uint32_t i = 0; i < world.face_count; ++i) {
    const formats::BspFace& face = bsp.faces[world.first_face + i];
    for (std::uint32_t k = 0; k < face.surfedge_count; ++k) {
      const std::int32_t surfedge = bsp.surfedges[face.first_surfedge + k];
      const auto& vertices = bsp.edges[static_cast<std::size_t>(std::abs(surfedge))].vertices;
      edges.push_back({Vec3d(bsp.vertices[vertices[0]]), Vec3d(bsp.vertices[vertices[1]])});
    }
  }
  return edges;
}

void draw_view(std::span<const Edge> edges, std::span<const Vec3d> path_world, const Projection& project,
               Canvas& io_canvas) {
  for (const auto& [from, to] : edges) io_canvas.line(project(from), project(to), 0.4, kWall, 0.18f);
  for (std::size_t i = 1; i < path_world.size(); ++i)
    io_canvas.line(project(path_world[i - 1]), project(path_world[i]), 1.5, kPath, 0.9f);
  if (path_world.empty()) return;
  io_canvas.dot(project(path_world.back()), 6, kEnd, 1);
  io_canvas.dot(project(path_world.front()), 6, kStart, 1);
}

}  // namespace

// Both views have the same scale, chosen so that they fit the width and together the height.
base::Result<base::ByteVector> draw_leak(const formats::Bsp& bsp, std::span<const Vec3d> path_world) {
  const std::vector<Edge> edges = list_world_edges(bsp);
  Bounds bounds;
  for (const Edge& edge : edges)
    for (const Vec3d& point : edge) bounds.add(point);
  for (const Vec3d& point : path_world) bounds.add(point);
  const Vec3d size = glm::max(bounds.maxs - bounds.mins, Vec3d(1.0));
  const double px_per_unit =
      std::min((kWidthPx - 2 * kMarginPx) / size.x, (kMaxHeightPx - 3 * kMarginPx) / (size.y + size.z));
  const auto px = [&](double units) { return static_cast<int>(std::ceil(units * px_per_unit)); };
  Canvas canvas(px(size.x) + 2 * kMarginPx, px(size.y) + px(size.z) + 3 * kMarginPx);
  const double plan_bottom_px = kMarginPx + px(size.y);
  draw_view(edges, path_world, {bounds.mins, 1, px_per_unit, {kMarginPx, plan_bottom_px}}, canvas);
  draw_view(edges, path_world,
            {bounds.mins, 2, px_per_unit, {kMarginPx, plan_bottom_px + kMarginPx + px(size.z)}}, canvas);
  return canvas.png();
}

}  // namespace temblor::app
