#include "client/hud/notices/damage_arcs.h"

#include <algorithm>
#include <cmath>

namespace temblor::client {

namespace {

constexpr double kArcLasts_s = 1, kArcFades_s = 0.5;
constexpr std::size_t kMaxHits = 4;
// Distances from the crosshair, in pixels of a frame of 240 lines.
constexpr int kLines = 240, kInnerRadius = 32, kRimRadius = 35, kOuterRadius = 40;
// Palette indices: red, and a brighter orange at the inner edge.
constexpr std::uint8_t kRed = 79, kRim = 233;
// The cosine of half the arc, 30 degrees.
constexpr double kHalfArc = 0.866;
// Nearer sources are inside the player and have no direction.
constexpr double kMinDistance_units = 1;

// The direction of a place on the screen: x right, y down; forward is up. (0, 0): none.
math::Vec2d find_direction(const math::Vec3& place_world, const render::Camera& camera) {
  const math::Vec2d away = math::Vec2d(place_world) - math::Vec2d(camera.origin_world);
  const double distance = glm::length(away);
  if (!(distance >= kMinDistance_units)) return {0, 0};
  const double yaw = glm::radians(static_cast<double>(camera.angles_deg.y));
  const math::Vec2d forward(std::cos(yaw), std::sin(yaw)), right(forward.y, -forward.x);
  return {glm::dot(away, right) / distance, -glm::dot(away, forward) / distance};
}

struct RingRadii {
  int inner, outer;
};

// Fills the part of a ring that is within the arc, in runs of pixels of each row.
void draw_ring(const Panel& middle, const math::Vec2d& direction, RingRadii radii, std::uint8_t color,
               float opacity) {
  const auto is_inside = [&](int x, int y) {
    const math::Vec2d place(x + 0.5, y + 0.5);
    const double distance = glm::length(place);
    return distance >= radii.inner && distance < radii.outer &&
           glm::dot(place, direction) >= kHalfArc * distance;
  };
  for (int y = -radii.outer; y < radii.outer; ++y)
    for (int x = -radii.outer; x < radii.outer; ++x) {
      if (!is_inside(x, y)) continue;
      const int first = x;
      while (x < radii.outer && is_inside(x, y)) ++x;
      middle.fill(first, y, x - first, 1, color, opacity);
    }
}

}  // namespace

void DamageArcs::advance(const Events& events, double time_s) {
  std::erase_if(hits_, [&](const Hit& hit) { return time_s - hit.since_s >= kArcLasts_s; });
  for (const net::Damage& damage : events.damages) {
    if ((damage.armor == 0 && damage.blood == 0) || damage.from == math::Vec3(0.0f)) continue;
    if (hits_.size() == kMaxHits) hits_.erase(hits_.begin());
    hits_.push_back({damage.from, time_s});
  }
}

void DamageArcs::draw(const Panel& panel, const render::Camera& camera, double time_s) const {
  // Like the crosshair, they follow the frame's height rather than the status bar's scale.
  const Panel middle = panel.with_scale(std::max(1, panel.frame_height_px() / kLines)).centered();
  for (const Hit& hit : hits_) {
    const math::Vec2d direction = find_direction(hit.from_world, camera);
    if (direction == math::Vec2d(0)) continue;
    const auto opacity =
        static_cast<float>(std::clamp((hit.since_s + kArcLasts_s - time_s) / kArcFades_s, 0.0, 1.0));
    draw_ring(middle, direction, {kInnerRadius, kRimRadius}, kRim, opacity);
    draw_ring(middle, direction, {kRimRadius, kOuterRadius}, kRed, opacity);
  }
}

}  // namespace temblor::client
