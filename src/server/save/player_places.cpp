#include "server/save/player_places.h"

#include "server/game.h"
#include "server/game/entity_fields.h"
#include "server/game/game_world.h"
#include "server/move_trace.h"
#include "server/session/clients.h"

namespace temblor::server {
namespace {

bool is_flying(MoveType type) {
  return type == MoveType::kFly || type == MoveType::kNoClip;
}

}  // namespace

PlayerPlaces read_player_places(Game& io_game, const Clients& clients) {
  PlayerPlaces places(clients.size());
  for (std::size_t slot = 0; slot < places.size(); ++slot) {
    if (!clients[slot].is_in_game() || clients[slot].is_bot()) continue;
    const Edict player = io_game.player(slot);
    places[slot] = {player[field::kOrigin], player[field::kViewAngles], player[field::kMoveType],
                    player.flags() & (flag::kGodMode | flag::kNoTarget)};
  }
  return places;
}

base::Status restore_player_place(Game& io_game, std::size_t slot, const PlayerPlace& place) {
  const vm::EntityIndex index = io_game.player_index(slot);
  const Edict player = io_game.player(slot);
  const auto move_type = static_cast<MoveType>(place.move_type);
  const math::Vec3 start = player[field::kOrigin];
  player.set(field::kOrigin, place.origin);
  if (move_type != MoveType::kNoClip && is_stuck(io_game.world(), index)) {
    player.set(field::kOrigin, start);
    return base::Ok{};
  }
  player.set_flag(place.cheats);
  if (is_flying(move_type)) player.set(field::kMoveType, place.move_type);
  player.set(field::kAngles, place.view_angles_deg);
  player.set(field::kFixAngle, 1.0f);
  return link(io_game.world(), index, TouchTriggers::kNo);
}

}  // namespace temblor::server
