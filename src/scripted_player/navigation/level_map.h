// Everything that players know of a level in advance: the facts of its entities, the space that they can
// occupy, and the graph of all places that they can reach. It never changes, so all players of a run share
// it.
#pragma once

#include <memory>

#include "scripted_player/navigation/level_facts.h"
#include "scripted_player/navigation/nav_graph.h"
#include "scripted_player/navigation/nav_space.h"

namespace temblor::player {

struct LevelMap {
  LevelFacts facts;
  NavSpace space;
  NavGraph graph;

  // Builds the map from a game whose players are in the level. The graph begins where they stand and at the
  // start points where they may respawn.
  static std::unique_ptr<const LevelMap> make(server::Game& io_game);

 private:
  // Members are initialized in order: `space` refers to `facts`, so the map is neither copied nor moved.
  LevelMap(server::Game& io_game, std::span<const math::Vec3> starts)
      : facts(read_level_facts(io_game)), space(io_game.world().level, facts), graph(space, starts) {}
};

}  // namespace temblor::player
