#include "scripted_player/decisions/lift_wait.h"

#include <algorithm>
#include <vector>

namespace temblor::player {
namespace {

constexpr std::size_t kMaxPlaces = 500;

// Whether the place is below the upper end of a lift that is not where the link needs it.
bool is_below_lift(const LevelFacts& facts, const MoverWatch& movers, const Link& link,
                   const math::Vec3& at) {
  // Half the player's width, and some space to stop.
  constexpr float kBeside_units = 28;
  for (const MoverCondition& condition : link.conditions) {
    if (condition.mover < 0 || movers.is_in(condition.mover, condition.states)) continue;
    const Mover& lift = facts.movers[static_cast<std::size_t>(condition.mover)];
    if (lift.kind != MoverKind::kLift) continue;
    const MoverPart& part = lift.parts[0];
    const math::Vec3 low = part.box.mins + part.places.back(), high = part.box.maxs + part.places.back();
    if (at.x > low.x - kBeside_units && at.x < high.x + kBeside_units && at.y > low.y - kBeside_units &&
        at.y < high.y + kBeside_units && at.z < high.z)
      return true;
  }
  return false;
}

bool can_pass(const MoverWatch& movers, const Link& link) {
  return link.kind == LinkKind::kWalk &&
         std::all_of(link.conditions.begin(), link.conditions.end(), [&](const MoverCondition& condition) {
           return condition.mover < 0 || movers.is_in(condition.mover, condition.states);
         });
}

}  // namespace

std::optional<math::Vec3> find_place_beside_lift(const NavGraph& graph, const LevelFacts& facts,
                                                 const MoverWatch& movers, const Link& link,
                                                 std::uint32_t from) {
  if (!is_below_lift(facts, movers, link, graph.place(from).at)) return std::nullopt;
  std::vector<std::uint32_t> found{from};
  for (std::size_t i = 0; i < found.size() && i < kMaxPlaces; ++i) {
    for (const Link& way : graph.place(found[i]).links) {
      if (!can_pass(movers, way) || std::find(found.begin(), found.end(), way.to) != found.end()) continue;
      if (!is_below_lift(facts, movers, link, graph.place(way.to).at)) return graph.place(way.to).at;
      found.push_back(way.to);
    }
  }
  return std::nullopt;
}

}  // namespace temblor::player
