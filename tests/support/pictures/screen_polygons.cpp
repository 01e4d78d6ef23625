#include "support/pictures/screen_polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::test {

using math::Vec2d;
using render::SurfaceIndex;

namespace {

Vec2d find_middle(const std::vector<Vec2d>& corners) {
  Vec2d sum(0.0);
  for (const Vec2d& corner : corners) sum += corner;
  return sum / static_cast<double>(corners.size());
}

// Whether a pixel's center is in the polygon; nothing if rounding decides.
std::optional<bool> holds(const ScreenPolygon& polygon, double x, double y) {
  bool inside = true;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Vec2d &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    const Vec2d along = b - a, to_pixel = Vec2d(x, y) - a;
    const double side = along.x * to_pixel.y - along.y * to_pixel.x;
    if (std::abs(side) < 1e-7 * (1 + glm::length(along))) return std::nullopt;
    inside = inside && side > 0;
  }
  return inside;
}

}  // namespace

ScreenPolygon any_polygon(const render::ViewFrame& view, Random& io_random) {
  ScreenPolygon polygon;
  // Corners on an ellipse, so the polygon is convex. Often partly outside the screen, or larger than it.
  const Vec2d middle(io_random.uniform(-0.5, 1.5) * view.width, io_random.uniform(-0.5, 1.5) * view.height);
  const Vec2d radius(io_random.log_uniform(0.5, 2.0 * view.width),
                     io_random.log_uniform(0.5, 2.0 * view.height));
  std::vector<double> turns;
  for (std::size_t i = 3 + io_random.below(6); i > 0; --i) turns.push_back(io_random.uniform(0, 6.283));
  std::sort(turns.begin(), turns.end());
  const double tilt = io_random.uniform(-1, 1);
  for (const double turn : turns) {
    const double y = middle.y + radius.y * std::sin(turn);
    polygon.corners.push_back({middle.x + radius.x * std::cos(turn) + tilt * (y - middle.y), y});
  }
  return polygon;
}

HandMadeTable::HandMadeTable(const render::ViewFrame& view, const std::vector<ScreenPolygon>& polygons)
    : view_(view) {
  add_surface(std::numeric_limits<render::SortKey>::max());
  fragments_.push_back({});
  for (const ScreenPolygon& polygon : polygons) add(polygon);
  row_begin_.assign(static_cast<std::size_t>(view.height) + 1, 0);
  for (int row = 0; row < view.height; ++row) {
    row_begin_[static_cast<std::size_t>(row)] = static_cast<std::uint32_t>(order_.size());
    for (std::uint32_t i = 0; i < edges_.size(); ++i)
      if (edges_[i].first_row == row) order_.push_back(i);
  }
  row_begin_.back() = static_cast<std::uint32_t>(order_.size());
}

render::EdgeTable HandMadeTable::view() const {
  return {
      edges_, order_, row_begin_, surfaces_, fragments_, {}, static_cast<std::uint32_t>(surfaces_.size())};
}

void HandMadeTable::add(const ScreenPolygon& polygon) {
  const auto surface = base::to_index<SurfaceIndex>(surfaces_.size());
  add_surface(polygon.key);
  fragments_.push_back({polygon.depth});
  const Vec2d middle = find_middle(polygon.corners);
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Vec2d &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    const Vec2d &top = a.y < b.y ? a : b, &bottom = a.y < b.y ? b : a;
    render::Edge edge{};
    edge.first_row = static_cast<std::int32_t>(std::max(0.0, std::ceil(top.y)));
    edge.last_row = static_cast<std::int32_t>(std::min(view_.height - 1.0, std::ceil(bottom.y) - 1));
    if (edge.first_row > edge.last_row) continue;
    edge.step = (bottom.x - top.x) / (bottom.y - top.y);
    edge.x_first = top.x + (edge.first_row - top.y) * edge.step;
    // The polygon is right of an edge if its center is.
    (top.x + edge.step * (middle.y - top.y) < middle.x ? edge.leading : edge.trailing) = surface;
    edges_.push_back(edge);
  }
}

void HandMadeTable::add_surface(render::SortKey key) {
  const auto number = static_cast<std::uint32_t>(surfaces_.size());
  surfaces_.push_back({key, 1, world::FaceIndex{0}, number, {}, number, 0});
}

std::vector<std::optional<std::uint32_t>> find_shown_draws(const render::ViewFrame& view,
                                                           const std::vector<ScreenPolygon>& polygons) {
  std::vector<std::optional<std::uint32_t>> pixels;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      std::optional<std::uint32_t> shown = 0;
      const ScreenPolygon* best = nullptr;
      bool is_clear = true;
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::optional<bool> inside = holds(polygons[i], x, y);
        is_clear = is_clear && inside;
        if (!inside || !*inside) continue;
        const bool nearer =
            best == nullptr || polygons[i].key < best->key ||
            (polygons[i].key == best->key && polygons[i].depth.at(x, y) > best->depth.at(x, y));
        if (!nearer) continue;
        best = &polygons[i];
        shown = static_cast<std::uint32_t>(i + 1);
      }
      pixels.push_back(is_clear ? shown : std::nullopt);
    }
  return pixels;
}

}  // namespace temblor::test
