// Bots: clients that QuakeC plays. They have a slot, a name and a body like all players, but no connection
// (DP_SV_BOTCLIENT). The server learns of new and removed bots in update_bot_clients().
#include <algorithm>
#include <cmath>

#include "server/game.h"

namespace temblor::server {

// The actions behind the built-in functions for bots (builtins/bots.cpp).
BotServices Game::bot_services() {
  return {.spawn_bot = [this] { return spawn_bot(); },
          .drop = [this](std::size_t slot) { return drop_player(slot); },
          .player_type = [this](std::size_t slot) { return player_type(slot); }};
}

// A slot that a client is about to use is taken, too, even though nobody plays in it yet.
PlayerType Game::player_type(std::size_t slot) const {
  if (bots_[slot]) return PlayerType::kBot;
  const bool has_client = services_.has_client ? services_.has_client(slot) : active_players_[slot];
  return has_client ? PlayerType::kHuman : PlayerType::kNobody;
}

// Uses the last free slot. The first ones are for people; the host has slot 0.
base::Result<vm::EntityIndex> Game::spawn_bot() {
  for (std::size_t slot = setup_.max_clients; slot-- > 0;) {
    if (player_type(slot) != PlayerType::kNobody) continue;
    bots_[slot] = true;
    TRY(const SpawnParameters parameters, new_parameters());
    TRY_STATUS(spawn_client(slot, parameters, "bot", 0));
    return player_index(slot);
  }
  return vm::kWorld;
}

// A bot goes at once. A person is dropped by the server after the tick, because it has a connection.
base::Status Game::drop_player(std::size_t slot) {
  if (bots_[slot]) return disconnect_client(slot);
  requests_.dropped_players.push_back(slot);
  return base::Ok{};
}

// 0 if the program does not declare clientcolors.
std::uint8_t Game::bot_colors(std::size_t slot) {
  return client_colors_field_ ? static_cast<std::uint8_t>(player(slot).whole(*client_colors_field_)) : 0;
}

// Applies what the bot's client would have sent. When the game turns the bot (fixangle), its view follows at
// once: there is no client to send the angle to.
void Game::apply_bot_input(std::size_t slot) {
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
