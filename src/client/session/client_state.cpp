#include "client/session/client_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace temblor::client {

bool is_in_combat(const Game& game, double time_s) {
  constexpr double kHurt_s = 5;
  return game.is_hunted || (game.last_damage_s && time_s - *game.last_damage_s < kHurt_s);
}

// New fog fades in over the mixture that was visible when its message arrived.
FogMixture compute_fog_mixture(const Game& game, double time_s) {
  if (!game.fog) return {};
  const double end_s = game.fog_since_s + static_cast<double>(game.fog->fade_s);
  const auto now = static_cast<float>(compute_elapsed_fraction(game.fog_since_s, end_s, time_s));
  const float before = 1 - now;
  return {.share_of_level = before * game.fog_before.share_of_level,
          .density = before * game.fog_before.density + now * game.fog->density,
          .color = before * game.fog_before.color + now * game.fog->color};
}

net::Fog compute_fog(const Game& game, const net::Fog& level_fog, double time_s) {
  const FogMixture mixture = compute_fog_mixture(game, time_s);
  return {.density = mixture.share_of_level * level_fog.density + mixture.density,
          .color = mixture.share_of_level * level_fog.color + mixture.color,
          .fade_s = 0};
}

void Events::clear() {
  temp_entities.clear();
  particles.clear();
  damages.clear();
  sounds.clear();
  stopped_sounds.clear();
  static_sounds.clear();
  marks.clear();
  leak_path.clear();
  prints.clear();
  notes.clear();
  commands.clear();
  bonus_flashes = 0;
  new_level = false;
}

namespace {

// The approximate memory of a list, without its spare capacity.
template <typename T>
std::size_t count_bytes(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

std::size_t count_bytes(const std::vector<std::string>& list) {
  std::size_t bytes = list.size() * sizeof(std::string);
  for (const std::string& text : list) bytes += text.size();
  return bytes;
}

}  // namespace

std::size_t ClientState::memory_bytes() const {
  const Events& e = events_;
  return sizeof(ClientState) + entities_.memory_bytes() + count_bytes(game_.models) +
         count_bytes(game_.sounds) + count_bytes(game_.players) + game_.ending_text.size() +
         game_.center_text.size() + count_bytes(e.temp_entities) + count_bytes(e.particles) +
         count_bytes(e.damages) + count_bytes(e.sounds) + count_bytes(e.stopped_sounds) +
         count_bytes(e.static_sounds) + count_bytes(e.marks) + count_bytes(e.prints) + count_bytes(e.notes) +
         count_bytes(e.commands);
}

base::Status ClientState::pass_over_unknown(const base::Error& error) {
  if (game_.signon < kPlaying) return error;
  if (!std::exchange(game_.has_noted_unknown, true))
    events_.notes.push_back(
        fmt::format("The server sent something that this client does not know: {}. The "
                    "rest of the packet is skipped.",
                    error.what));
  return base::Ok{};
}

// The packet that reports a death has the player's last place, too.
void ClientState::note_death() {
  const bool was_dead = std::exchange(game_.is_dead, game_.stat(Stat::kHealth) <= 0);
  if (was_dead || !game_.is_dead) return;
  std::vector<EntityPlace> places;
  entities_.copy_latest(places);
  const auto found = std::ranges::find(places, game_.view_entity, &EntityPlace::number);
  if (found != places.end()) game_.death_place = found->origin_world;
}

void ClientState::end_packet() {
  entities_.end_packet();
  note_death();
}

std::span<const InterpolatedEntity> ClientState::interpolate_entities(double time_s,
                                                                      const ClientSettings& settings) {
  return entities_.interpolate(time_s, {game_.view_entity, game_.players.size()}, settings);
}

FrameBlend ClientState::interpolate_weapon_frame(double time_s, const ClientSettings& settings) const {
  return blend_frames(weapon_, time_s, game_.data.weapon_model, settings);
}

}  // namespace temblor::client
