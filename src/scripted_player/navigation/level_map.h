// Everything that players know of a level in advance: the facts of its entities, the space that they can
// occupy, and the graph of all places that they can reach. It never changes, so all players of a run share
// it.
#pragma once

#include <memory>

#include "scripted_player/navigation/graph_cache.h"
#include "scripted_player/navigation/level_facts.h"
#include "scripted_player/navigation/nav_graph.h"
#include "scripted_player/navigation/nav_space.h"

namespace temblor::player {

struct LevelMap {
  LevelFacts facts;
  NavSpace space;
  std::shared_ptr<const NavGraph> shared_graph;
  const NavGraph& graph;

  // Builds the map from a game whose players are in the level. The graph begins where they stand and at the
  // start points where they may respawn. It comes from the cache if there is one.
  static std::unique_ptr<const LevelMap> make(server::Game& io_game, GraphCache* io_graphs = nullptr);

 private:
  // Members are initialized in order: `space` refers to `facts`, so the map is neither copied nor moved.
  LevelMap(server::Game& io_game, std::span<const math::Vec3> starts, GraphCache* io_graphs)
      : facts(read_level_facts(io_game)),
        space(io_game.world().level, facts),
        shared_graph(io_graphs != nullptr ? io_graphs->find_or_make(space, starts)
                                          : std::make_shared<const NavGraph>(space, starts)),
        graph(*shared_graph) {}
};

}  // namespace temblor::player
