#include "client/view/audio_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/hash.h"
#include "client/effects/effect_random.h"
#include "math/angles.h"

namespace temblor::client {
namespace {

using net::TempEntityKind;

// Files that the client plays without being asked by the server; stock games contain them.
constexpr const char* kAmbientWater = "ambience/water1.wav";
constexpr const char* kAmbientSky = "ambience/wind2.wav";
constexpr const char* kExplosion = "weapons/r_exp3.wav";

// Nails click on stone; one in five ricochets. The hit's number seeds the choice, so that a demo sounds the
// same each time.
const char* choose_nail_sound(std::uint32_t hit_number) {
  EffectRandom random(base::hash_with(hit_number, 0));
  if (random.below(5) != 0) return "weapons/tink1.wav";
  switch (random.below(4)) {
    case 1:
      return "weapons/ric1.wav";
    case 2:
      return "weapons/ric2.wav";
    default:
      return "weapons/ric3.wav";
  }
}

// Returns the sound of a temporary entity; null for silent ones.
const char* find_sound_name(TempEntityKind kind, std::uint32_t hit_number) {
  switch (kind) {
    case TempEntityKind::kSpike:
    case TempEntityKind::kSuperSpike:
      return choose_nail_sound(hit_number);
    case TempEntityKind::kWizSpike:
      return "wizard/hit.wav";
    case TempEntityKind::kKnightSpike:
      return "hknight/hit.wav";
    case TempEntityKind::kExplosion:
    case TempEntityKind::kTarExplosion:
    case TempEntityKind::kExplosion2:
      return kExplosion;
    default:
      return nullptr;
  }
}

// Volumes travel as bytes, 255 for full.
float to_volume(std::uint8_t volume) {
  return static_cast<float>(volume) / 255;
}

// Game code plays shouts on channel 2 and shots on channel 1. Doors and lifts, which are submodels of the
// level, use channel 2 too. Sounds of entities out of view count.
bool is_threat(const Game& game, std::span<const InterpolatedEntity> entities, const net::Sound& what) {
  constexpr int kWeaponChannel = 1, kVoiceChannel = 2;
  if (what.entity == 0 || (what.channel != kWeaponChannel && what.channel != kVoiceChannel)) return false;
  const InterpolatedEntity* entity = find_entity(entities, what.entity);
  return entity == nullptr || entity->model >= game.models.size() ||
         !game.models[entity->model].starts_with('*');
}

}  // namespace

// Starts the ambient sounds of water and wind, two of the four kinds for which a level's leaves have volumes.
// Stock Quake does not use the others (slime and lava) either.
void AudioScene::begin_ambients() {
  events_.new_ambients = true;
  events_.ambients = {sounds_.looped_sound(kAmbientWater), sounds_.looped_sound(kAmbientSky), nullptr,
                      nullptr};
}

void AudioScene::begin_level(const Game& game) {
  sounds_.begin_level(game.sounds);
  reported_statics_.clear();
  // Events of the last level are dropped.
  events_.clear();
  events_.stops_all = true;
  begin_ambients();
}

void AudioScene::resume(std::span<const net::SpawnStaticSound> static_sounds) {
  const bool had_new_ambients = events_.new_ambients;
  events_.clear();
  events_.stops_all = true;
  if (had_new_ambients) begin_ambients();
  for (const net::SpawnStaticSound& what : static_sounds) add_sound(what);
}

// Silences the level but keeps its sounds loaded.
void AudioScene::end_level() {
  resume({});
  scene_.ambient_levels = {};
  scene_.listener.underwater = false;
}

void AudioScene::add_sound(const net::TempEntity& what) {
  if (const char* name = find_sound_name(what.kind, ++hit_count_); name != nullptr)
    events_.started.push_back({.sound = sounds_.sound(std::string(name)), .origin_world = what.origin});
}

// Only looping sounds can be static, as in stock Quake. Others are reported once.
void AudioScene::add_sound(const net::SpawnStaticSound& what) {
  const audio::SoundPtr sound = sounds_.sound(what.sound);
  if (sound == nullptr) return;
  if (!sound->loop) {
    if (std::find(reported_statics_.begin(), reported_statics_.end(), what.sound) != reported_statics_.end())
      return;
    reported_statics_.push_back(what.sound);
    notes_.push_back(
        fmt::format("sound/{}: cannot be used as an ambient sound, as it does not loop", sound->name));
    return;
  }
  events_.statics.push_back({sound, what.origin, to_volume(what.volume), what.attenuation});
}

void AudioScene::advance(const Game& game, const Events& events, std::span<const InterpolatedEntity> entities,
                         const world::Level& level, const PlayerView& view, const audio::Volumes& volumes) {
  scene_.listener.origin_world = view.camera.origin_world;
  scene_.listener.right = math::Vec3(math::basis_from_angles(view.camera.angles_deg).right);
  scene_.listener.entity = game.view_entity;
  scene_.listener.underwater = view.underwater;
  scene_.ambient_levels = level.leaf(view.leaf).ambient;
  scene_.volumes = volumes;
  for (const net::SpawnStaticSound& what : events.static_sounds) add_sound(what);
  for (const net::Sound& what : events.sounds)
    events_.started.push_back({.sound = sounds_.sound(what.sound),
                               .entity = what.entity,
                               .channel = what.channel,
                               .origin_world = what.origin,
                               .volume = to_volume(what.volume),
                               .attenuation = what.attenuation,
                               .is_threat = is_threat(game, entities, what)});
  for (const net::TempEntity& what : events.temp_entities) add_sound(what);
  for (const net::StopSound& what : events.stopped_sounds)
    events_.stopped.push_back({what.entity, what.channel});
}

void AudioScene::play_local(const std::string& name, float volume) {
  // In the original, a menu sound cut off a sound of the player; here it does not.
  events_.started.push_back({.sound = sounds_.sound(name),
                             .entity = scene_.listener.entity,
                             .origin_world = scene_.listener.origin_world,
                             .volume = volume});
}

std::vector<std::string> AudioScene::take_notes() {
  std::vector<std::string> notes = sounds_.take_notes();
  for (std::string& note : notes_) notes.push_back(std::move(note));
  notes_.clear();
  return notes;
}

}  // namespace temblor::client
