// Keeps players where they are when their level is read from disk again, so that mappers see at once how a
// change looks from there.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::server {

class Game;
class Clients;

struct PlayerPlace {
  math::Vec3 origin{0.0f}, view_angles_deg{0.0f};
  float move_type = 0;  // MoveType
  int cheats = 0;       // god mode and notarget, bits of `flags`
};
// By slot; nothing for free slots and bots.
using PlayerPlaces = std::vector<std::optional<PlayerPlace>>;

PlayerPlaces read_player_places(Game& io_game, const Clients& clients);

// Puts a player, which has just spawned, back to its place; also flying or without clipping, if it was.
// Leaves it at the start if something solid is there now. Fails if QuakeC does.
base::Status restore_player_place(Game& io_game, std::size_t slot, const PlayerPlace& place);

}  // namespace temblor::server
