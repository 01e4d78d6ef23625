// Finds everything that a player can reach in a level, by moving from position to position with all doors
// open and all lifts running. The moves are coarse: walking, stepping up, dropping, jumping at full speed,
// swimming, climbing out of water, and using teleporters, lifts, and push triggers. Rocket jumps and trains
// are not included.
#pragma once

#include <unordered_set>
#include <vector>

#include "world/hull_cells.h"
#include "world/level.h"

namespace temblor::test {

class Explorer {
 public:
  explicit Explorer(const world::Level& level);

  // Explores everything within reach from these player origins.
  void explore(const std::vector<math::Vec3>& starts);

  // Whether a player at any reached position touches the box, as with triggers and items.
  bool touches(const math::Bounds& box) const;
  std::size_t position_count() const { return positions_.size(); }

 private:
  // A player in `box` can get to `to`, or with a velocity is thrown from where it is. `to` is the middle of a
  // raised lift if the distance to its edge is not 0.
  struct Link {
    math::Bounds box;
    math::Vec3 to;
    math::Vec3 velocity{0.0f};
    float to_edge = 0;
  };

  void collect_links();
  void visit(const math::Vec3& position);
  void leave_lift(const Link& link);
  void walk(const math::Vec3& position, const math::Vec3& direction);
  void fly(math::Vec3 position, math::Vec3 velocity);
  void swim(const math::Vec3& position);
  void land(const math::Vec3& position);
  void follow_links(const math::Vec3& position);
  world::Trace trace(const math::Vec3& from, const math::Vec3& to);
  bool is_water(const math::Vec3& position);
  bool is_deadly(const math::Vec3& position);

  const world::Level& level_;
  world::HullCells player_hull_, point_hull_;
  std::vector<Link> links_;
  std::unordered_set<std::uint64_t> visited_;
  std::vector<math::Vec3> positions_, pending_;
};

// The bounds of an entity's brush model, or a box around its origin.
math::Bounds entity_box(const world::Level& level, const formats::Entity& entity);

}  // namespace temblor::test
