#include "scripted_player/navigation/level_map.h"

namespace temblor::player {

std::unique_ptr<const LevelMap> LevelMap::make(server::Game& io_game, GraphCache* io_graphs) {
  std::vector<math::Vec3> starts;
  for (std::size_t slot = 0; slot < io_game.setup().max_clients; ++slot) {
    const server::Edict player = io_game.player(slot);
    if (player[server::field::kHealth] > 0) starts.push_back(player[server::field::kOrigin]);
  }
  // Players may also respawn at start points.
  const bool is_deathmatch = io_game.machine().global_float(server::global::kDeathmatch) != 0;
  for (std::uint32_t i = 1; i < io_game.world().edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (io_game.world().edicts.is_free(entity)) continue;
    const std::string name = class_name(io_game, entity);
    if (name == "info_player_start" ||
        name == (is_deathmatch ? "info_player_deathmatch" : "info_player_coop"))
      // Game code spawns players 1 unit above the start point, so that they are not stuck in the floor.
      starts.push_back(io_game.world().edicts[entity][server::field::kOrigin] + math::Vec3(0, 0, 1));
  }
  return std::unique_ptr<const LevelMap>(new LevelMap(io_game, starts, io_graphs));
}

}  // namespace temblor::player
