#include "client/client_state.h"

namespace temblor::client {

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
