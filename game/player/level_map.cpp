#include "game/player/level_map.h"

namespace temblor::player {

std::unique_ptr<const LevelMap> LevelMap::make(server::Game& io_game) {
  std::vector<math::Vec3> starts;
  for (std::size_t slot = 0; slot < io_game.setup().max_clients; ++slot) {
    const server::Edict player = io_game.player(slot);
    if (player[server::field::kHealth] > 0) starts.push_back(player[server::field::kOrigin]);
  }
  return std::unique_ptr<const LevelMap>(new LevelMap(io_game, starts));
}

}  // namespace temblor::player
