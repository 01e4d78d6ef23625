#include "client/session/client_state.h"

namespace temblor::client {

FogMixture fog_mixture_at(const Game& game, double time_s) {
  if (!game.fog) return {};
  const double end_s = game.fog_since_s + static_cast<double>(game.fog->fade_s);
  const auto now = static_cast<float>(fraction_passed(game.fog_since_s, end_s, time_s));
  const float before = 1 - now;
  return {.share_of_level = before * game.fog_before.share_of_level,
          .density = before * game.fog_before.density + now * game.fog->density,
          .color = before * game.fog_before.color + now * game.fog->color};
}

net::Fog fog_at(const Game& game, const net::Fog& of_level, double time_s) {
  const FogMixture mixture = fog_mixture_at(game, time_s);
  return {.density = mixture.share_of_level * of_level.density + mixture.density,
          .color = mixture.share_of_level * of_level.color + mixture.color,
          .fade_s = 0};
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

namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

std::size_t bytes_of(const std::vector<std::string>& list) {
  std::size_t bytes = list.size() * sizeof(std::string);
  for (const std::string& text : list) bytes += text.size();
  return bytes;
}

}  // namespace

std::size_t ClientState::memory_bytes() const {
  const Events& e = events_;
  return sizeof(ClientState) + entities_.memory_bytes() + bytes_of(game_.models) + bytes_of(game_.sounds) +
         bytes_of(game_.players) + game_.ending_text.size() + game_.center_text.size() +
         bytes_of(e.temp_entities) + bytes_of(e.particles) + bytes_of(e.damages) + bytes_of(e.sounds) +
         bytes_of(e.stopped_sounds) + bytes_of(e.static_sounds) + bytes_of(e.prints) + bytes_of(e.commands);
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
