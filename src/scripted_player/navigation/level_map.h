// All that players know of a level beforehand; one for all of them.
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

  // From where the players of the game stand.
  static std::unique_ptr<const LevelMap> make(server::Game& io_game);

 private:
  LevelMap(server::Game& io_game, std::span<const math::Vec3> starts)
      : facts(read_level_facts(io_game)), space(io_game.world().level, facts), graph(space, starts) {}
};

}  // namespace temblor::player
