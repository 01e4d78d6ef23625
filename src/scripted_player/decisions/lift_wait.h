// Where to wait for a lift. A lift stays up, or turns back, while a player is below it: its trigger reaches
// from its upper to its lower end.
#pragma once

#include <cstdint>
#include <optional>

#include "scripted_player/navigation/level_facts.h"
#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/nav_graph.h"

namespace temblor::player {

// If a player at `from` is below a lift for which `link` waits, returns the nearest place beside it that can
// be walked to.
std::optional<math::Vec3> find_place_beside_lift(const NavGraph& graph, const LevelFacts& facts,
                                                 const MoverWatch& movers, const Link& link,
                                                 std::uint32_t from);

}  // namespace temblor::player
