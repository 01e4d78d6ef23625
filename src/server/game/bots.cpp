// Clients that the program plays: they have a place, a name and a body like everybody, and no connection.
#include <algorithm>
#include <cmath>

#include "server/game.h"

namespace temblor::server {

PlayerPlaces Game::player_places() {
  return {.spawn_bot = [this] { return spawn_bot(); },
          .drop = [this](std::size_t slot) { return drop_player(slot); },
          .type_of = [this](std::size_t slot) { return type_of_player(slot); }};
}

PlayerType Game::type_of_player(std::size_t slot) const {
  if (bots_[slot]) return PlayerType::kBot;
  const bool has_client = services_.has_client ? services_.has_client(slot) : active_players_[slot];
  return has_client ? PlayerType::kHuman : PlayerType::kNobody;
}

// From the last place down: the first ones are for people, of whom the first is the host.
base::Result<vm::EntityIndex> Game::spawn_bot() {
  for (std::size_t slot = setup_.max_clients; slot-- > 0;) {
    if (type_of_player(slot) != PlayerType::kNobody) continue;
    bots_[slot] = true;
    TRY(const SpawnParameters parameters, new_parameters());
    TRY_STATUS(put_in(slot, parameters, "bot", 0));
    return player_index(slot);
  }
  return vm::kWorld;
}

base::Status Game::drop_player(std::size_t slot) {
  if (bots_[slot]) return take_out(slot);
  requests_.dropped_players.push_back(slot);
  return base::Ok{};
}

std::uint8_t Game::bot_colors(std::size_t slot) {
  return client_colors_field_ ? static_cast<std::uint8_t>(player(slot).whole(*client_colors_field_)) : 0;
}

// What its client would have sent. Where the game has turned it, it looks; there is no client to be told.
void Game::take_bot_input(std::size_t slot) {
  const Edict edict = player(slot);
  if (edict[field::kFixAngle] != 0) {
    edict.set(field::kViewAngles, edict[field::kAngles]);
    edict.set(field::kFixAngle, 0);
  }
  const math::Vec3 wish = movement_field_ ? edict[*movement_field_] : math::Vec3(0.0f);
  edict.set(field::kTeam, static_cast<float>((bot_colors(slot) & 15) + 1));
  move_player(
      world_, edict.index(),
      {.view_angles_deg = edict[field::kViewAngles], .forward = wish.x, .side = wish.y, .up = wish.z});
}

}  // namespace temblor::server
