#include "lab/visible_faces/portal_flood.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "lab/visible_faces/portal_window.h"
#include "world/visibility.h"

namespace temblor::lab {

namespace {

// Units. An eye that is nearer to a portal may look through it in any direction.
constexpr double kNearPortal = 0.25;
// An eye behind a portal's plane sees nothing through it, up to this rounding error.
constexpr double kBehind = 1e-3;
// Parts of a portal with a smaller distance along the view are not projected. Where the eye is farther than
// kNearPortal from the portal, they are not on the screen.
constexpr double kNearestZ = 1e-3;
// Pixels, around a projected portal.
constexpr double kSlack = 1;
constexpr double kFarOutside = 1 << 20;  // pixels; larger numbers are clamped, so that sums fit an int

// The smallest interval of a linear function of the screen.
struct Range {
  double lowest = kFarOutside, highest = -kFarOutside;
  void add(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  Interval widen() const {
    const auto clamp = [](double value) { return std::clamp(value, -kFarOutside, kFarOutside); };
    return {static_cast<std::int32_t>(std::floor(clamp(lowest - kSlack))),
            static_cast<std::int32_t>(std::ceil(clamp(highest + kSlack)))};
  }
};

class PortalFlood {
 public:
  PortalFlood(const LevelPortals& level, const render::ViewFrame& view, const FloodRules& rules,
              base::Arena& arena)
      : level_(level),
        view_(view),
        rules_(rules),
        whole_(PortalWindow::whole(view.width, view.height)),
        leaf_count_(level.leaf_begin.size() - 1),
        windows_(arena.allocate_filled(leaf_count_, PortalWindow::empty())),
        visits_(arena.allocate_filled<std::uint8_t>(leaf_count_, 0)),
        is_waiting_(arena.allocate_filled<std::uint8_t>(leaf_count_, 0)),
        waiting_(arena.allocate<std::uint32_t>(leaf_count_)),
        is_projected_(arena.allocate_filled<std::uint8_t>(level.portals.size(), 0)),
        openings_(arena.allocate<PortalWindow>(level.portals.size())),
        leaves_(arena.allocate_filled<std::uint8_t>((leaf_count_ + 6) / 8, 0)) {}

  void flood() {
    const auto eye_leaf = static_cast<std::uint32_t>(view_.eye_leaf);
    see(eye_leaf, whole_);
    while (waiting_count_ > 0) {
      const std::uint32_t leaf = waiting_[next_waiting_];
      next_waiting_ = (next_waiting_ + 1) % leaf_count_;
      --waiting_count_;
      is_waiting_[leaf] = 0;
      visit(leaf);
    }
  }
  FloodResult result() const { return {leaves_, portals_clipped_, leaves_reached_}; }

 private:
  void visit(std::uint32_t leaf) {
    ++visits_[leaf];
    const PortalWindow window = windows_[leaf];
    for (std::uint32_t i = level_.leaf_begin[leaf]; i < level_.leaf_begin[leaf + 1]; ++i) {
      const std::uint32_t number = level_.portal_numbers[i];
      const Portal& portal = level_.portals[number];
      const bool is_in_front = portal.leaves[0] == leaf;
      const std::uint32_t behind = portal.leaves[is_in_front ? 1 : 0];
      if (!can_enter(behind) || windows_[behind].contains(window)) continue;
      const double height = glm::dot(portal.normal, view_.eye_world) - portal.distance;
      if ((is_in_front ? height : -height) < -kBehind) continue;
      ++portals_clipped_;
      PortalWindow through = find_opening(number, height);
      through.intersect(window);
      if (rules_.uses_octagons) through.tighten();
      if (!through.is_empty() && !windows_[behind].contains(through)) see(behind, through);
    }
  }

  bool can_enter(std::uint32_t leaf) const {
    return rules_.enterable.empty() || world::is_in_pvs(rules_.enterable, world::LeafIndex{leaf});
  }

  void see(std::uint32_t leaf, const PortalWindow& window) {
    if (windows_[leaf].is_empty()) {
      ++leaves_reached_;
      leaves_[(leaf - 1) / 8] |= static_cast<std::uint8_t>(1 << (leaf - 1) % 8);
    }
    windows_[leaf].join(window);
    if (visits_[leaf] + 1 >= kMaxLeafVisits) windows_[leaf] = whole_;
    if (is_waiting_[leaf] != 0) return;
    is_waiting_[leaf] = 1;
    waiting_[(next_waiting_ + waiting_count_++) % leaf_count_] = leaf;
  }

  // Where the screen shows the portal.
  const PortalWindow& find_opening(std::uint32_t number, double height) {
    if (is_projected_[number] == 0) {
      is_projected_[number] = 1;
      openings_[number] = is_near(level_.portals[number], height) ? whole_ : project(level_.portals[number]);
    }
    return openings_[number];
  }

  bool is_near(const Portal& portal, double height) const {
    return std::abs(height) <= kNearPortal * glm::length(portal.normal) &&
           glm::all(glm::lessThanEqual(portal.mins - kNearPortal, view_.eye_world)) &&
           glm::all(glm::lessThanEqual(view_.eye_world, portal.maxs + kNearPortal));
  }

  PortalWindow project(const Portal& portal) const {
    Range x, y, sum, difference;
    bool has_points = false;
    const auto add = [&](const math::Vec3d& point) {
      const math::Vec2d on_screen = view_.to_screen(point);
      x.add(on_screen.x);
      y.add(on_screen.y);
      sum.add(on_screen.x + on_screen.y);
      difference.add(on_screen.x - on_screen.y);
      has_points = true;
    };
    const std::span<const math::Vec3d> corners =
        std::span(level_.corners).subspan(portal.first_corner, portal.corner_count);
    math::Vec3d before = view_.to_view(corners.back());
    for (const math::Vec3d& corner : corners) {
      const math::Vec3d here = view_.to_view(corner);
      if ((before.z < kNearestZ) != (here.z < kNearestZ)) {
        math::Vec3d cut = before + (here - before) * ((kNearestZ - before.z) / (here.z - before.z));
        cut.z = kNearestZ;
        add(cut);
      }
      if (here.z >= kNearestZ) add(here);
      before = here;
    }
    if (!has_points) return PortalWindow::empty();
    if (!rules_.uses_octagons) return {x.widen(), y.widen(), whole_.sum, whole_.difference};
    return {x.widen(), y.widen(), sum.widen(), difference.widen()};
  }

  const LevelPortals& level_;
  const render::ViewFrame& view_;
  const FloodRules& rules_;
  const PortalWindow whole_;
  const std::size_t leaf_count_;
  std::span<PortalWindow> windows_;              // by leaf; empty: not reached
  std::span<std::uint8_t> visits_, is_waiting_;  // by leaf
  std::span<std::uint32_t> waiting_;             // a ring of leaves
  std::size_t next_waiting_ = 0, waiting_count_ = 0;
  std::span<std::uint8_t> is_projected_;  // by portal
  std::span<PortalWindow> openings_;      // by portal
  std::span<std::uint8_t> leaves_;
  std::uint64_t portals_clipped_ = 0, leaves_reached_ = 0;
};

}  // namespace

FloodResult flood_portals(const LevelPortals& level, const render::ViewFrame& view, const FloodRules& rules,
                          base::Arena& arena) {
  PortalFlood flood(level, view, rules, arena);
  flood.flood();
  return flood.result();
}

}  // namespace temblor::lab
