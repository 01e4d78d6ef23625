// Where a player can get to in a level: found by trying, from place to place, with all doors open and all
// lifts running. Coarse: it walks, steps up, drops, jumps at full speed, swims and climbs out of water, takes
// teleporters, lifts and pushes; it neither jumps from shots nor rides trains.
#pragma once

#include <unordered_set>
#include <vector>

#include "world/level.h"

namespace temblor::test {

class Explorer {
 public:
  explicit Explorer(const world::Level& level);

  // Everything within reach from these origins of players.
  void explore(const std::vector<math::Vec3>& starts);

  // Whether a player somewhere there touches the box, as triggers and items are touched.
  bool touches(const math::Bounds& box) const;
  std::size_t place_count() const { return places_.size(); }

 private:
  struct Link {
    math::Bounds box;  // whoever is in it ...
    math::Vec3 to;     // ... may come out here
    math::Vec3 velocity{0.0f};
  };

  void collect_links();
  void visit(const math::Vec3& place);
  void walk(const math::Vec3& place, const math::Vec3& way);
  void fly(math::Vec3 place, math::Vec3 velocity);
  void swim(const math::Vec3& place);
  void land(const math::Vec3& place);
  void follow_links(const math::Vec3& place);
  bool is_water(const math::Vec3& place) const;
  bool is_deadly(const math::Vec3& place) const;

  const world::Level& level_;
  std::vector<Link> links_;
  std::unordered_set<std::uint64_t> known_;
  std::vector<math::Vec3> places_, waiting_;
};

// The box of an entity in the level: of its brushes, or around its origin.
math::Bounds entity_box(const world::Level& level, const formats::Entity& entity);

}  // namespace temblor::test
