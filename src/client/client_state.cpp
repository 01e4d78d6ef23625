#include "client/client_state.h"

#include <utility>

namespace temblor::client {

net::Fog fog_at(const Game& game, const net::Fog& of_level, double time_s) {
  net::Fog fog = of_level;
  if (game.fog) {
    const net::Fog& from = game.fog_before ? *game.fog_before : of_level;
    const double end_s = game.fog_since_s + static_cast<double>(game.fog->fade_s);
    const auto fraction = static_cast<float>(fraction_passed(game.fog_since_s, end_s, time_s));
    fog.density = from.density + (game.fog->density - from.density) * fraction;
    fog.colour = from.colour + (game.fog->colour - from.colour) * fraction;
  }
  fog.fade_s = 0;
  return fog;
}

void Events::clear() {
  temp_entities.clear();
  particles.clear();
  damages.clear();
  sounds.clear();
  stopped_sounds.clear();
  static_sounds.clear();
  prints.clear();
  commands.clear();
  bonus_flashes = 0;
  new_level = false;
}

void ClientState::end_packet() {
  entities_.end_packet();
}

std::span<const SeenEntity> ClientState::entities_at(double time_s, const ClientSettings& settings) {
  return entities_.at(time_s, {game_.view_entity, game_.players.size()}, settings);
}

FrameBlend ClientState::weapon_frame_at(double time_s, const ClientSettings& settings) const {
  return frames_at(weapon_, time_s, game_.data.weapon_model, settings);
}

}  // namespace temblor::client
