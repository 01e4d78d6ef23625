#include "lab/world_light/lit_polygons.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab {

namespace {

WorldCorner interpolate(const WorldCorner& a, const WorldCorner& b, double share) {
  WorldCorner corner{a.at + (b.at - a.at) * share, {}};
  for (std::size_t i = 0; i < corner.light.size(); ++i)
    corner.light[i] = std::lerp(a.light[i], b.light[i], static_cast<float>(share));
  return corner;
}

base::ArenaVector<WorldCorner> clip(const base::ArenaVector<WorldCorner>& corners,
                                    const render::FrustumPlane& plane, base::Arena& arena) {
  base::ArenaVector<WorldCorner> inside(arena, corners.size() + 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const WorldCorner& here = corners[i];
    const WorldCorner& next = corners[(i + 1) % corners.size()];
    const double d_here = glm::dot(plane.normal, here.at) + plane.offset;
    const double d_next = glm::dot(plane.normal, next.at) + plane.offset;
    if (d_here >= 0) inside.push_back(here);
    if ((d_here < 0) != (d_next < 0)) inside.push_back(interpolate(here, next, d_here / (d_here - d_next)));
  }
  return inside;
}

}  // namespace

LitPolygon place_polygon(const render::ViewFrame& view, std::span<const WorldCorner> corners, bool over_z,
                         base::Arena& arena) {
  base::ArenaVector<WorldCorner> clipped(arena, corners.size());
  for (const WorldCorner& corner : corners) clipped.push_back(corner);
  for (const render::FrustumPlane& plane : view.frustum) {
    const bool is_inside = std::all_of(clipped.begin(), clipped.end(), [&](const WorldCorner& corner) {
      return glm::dot(plane.normal, corner.at) + plane.offset >= 0;
    });
    if (!is_inside) clipped = clip(clipped, plane, arena);
  }
  LitPolygon polygon{};
  if (clipped.size() < 3) return polygon;
  const std::span<ScreenCorner> placed = arena.allocate<ScreenCorner>(clipped.size());
  polygon.least = polygon.most = clipped[0].light;
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    math::Vec3d in_view = view.to_view(clipped[i].at);
    in_view.z = std::max(in_view.z, view.near_z);  // rounding
    const math::Vec2d at = view.to_screen(in_view);
    placed[i] = {at.x, at.y, {}};
    for (std::size_t channel = 0; channel < kMaxChannels; ++channel) {
      const float light = clipped[i].light[channel];
      placed[i].light[channel] = over_z ? light / in_view.z : double{light};
      polygon.least[channel] = std::min(polygon.least[channel], light);
      polygon.most[channel] = std::max(polygon.most[channel], light);
    }
  }
  const auto [top, bottom] = std::ranges::minmax(placed, {}, &ScreenCorner::y);
  polygon.corners = placed;
  polygon.top = top.y;
  polygon.bottom = bottom.y;
  return polygon;
}

RowLight cross_row(const LitPolygon& polygon, double y) {
  const double row = std::clamp(y, polygon.top, polygon.bottom);
  RowLight crossed{INFINITY, -INFINITY, {}, {}};
  const auto add = [&](double x, const std::array<double, kMaxChannels>& light) {
    if (x < crossed.left) {
      crossed.left = x;
      crossed.light_left = light;
    }
    if (x > crossed.right) {
      crossed.right = x;
      crossed.light_right = light;
    }
  };
  const ScreenCorner* a = &polygon.corners.back();
  for (const ScreenCorner& b : polygon.corners) {
    const ScreenCorner& upper = a->y <= b.y ? *a : b;
    const ScreenCorner& lower = a->y <= b.y ? b : *a;
    a = &b;
    if (row < upper.y || row > lower.y) continue;
    if (lower.y <= upper.y) {  // along the row
      add(upper.x, upper.light);
      add(lower.x, lower.light);
      continue;
    }
    const double share = (row - upper.y) / (lower.y - upper.y);
    std::array<double, kMaxChannels> light;
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] = upper.light[i] + (lower.light[i] - upper.light[i]) * share;
    add(upper.x + (lower.x - upper.x) * share, light);
  }
  return crossed;
}

}  // namespace temblor::lab
