// The mixer's input, except music: the state of the world at one moment (Scene) and what changed since
// (SoundEvents).
//
// The client fills both once per frame. A scene is a snapshot and may be dropped; events must arrive exactly
// once and in order. Positions and distances are in map units, in world space.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "audio/sound.h"
#include "math/vec.h"

namespace temblor::audio {

struct Listener {
  math::Vec3 origin_world{0.0f};
  math::Vec3 right{0, -1, 0};  // unit vector that points out of the right ear
  std::int32_t entity = 0;     // its own sounds play without attenuation, equally in both ears
  bool underwater = false;
};

// Kinds of ambient sound that a leaf can have: water, sky, slime, lava. They have no position.
constexpr std::size_t kAmbients = 4;

struct Volumes {
  float sounds = 0.7f;           // 0 to 1
  float ambient = 0.3f;          // 0 to 1, a factor for Scene::ambient_levels
  float music = 1;               // 0 to 1
  float muffled_underwater = 0;  // 0 (clear, as in air) to 1 (dull)
  bool music_layers = true;      // the combat layers of music are heard
  bool focus = true;             // the nearest threat is the clearest, see mixing/focus.h
};

struct Scene {
  Listener listener;
  std::array<std::uint8_t, kAmbients> ambient_levels{};  // 0 to 255, from the listener's leaf
  Volumes volumes;
};

// StartedSound::entity of a sound that belongs to no entity.
constexpr std::int32_t kNoEntity = -1;
// Channels. kAnyChannel replaces whatever its entity plays; kFreeChannel replaces nothing; any other number
// replaces the sound on the same channel of the same entity.
constexpr int kAnyChannel = -1, kFreeChannel = 0;

struct StartedSound {
  SoundPtr sound;
  std::int32_t entity = kNoEntity;
  int channel = kFreeChannel;
  math::Vec3 origin_world{0.0f};
  float volume = 1;        // 0 to 1
  float attenuation = 1;   // silent at 1000 units / attenuation; 0: equally loud everywhere
  bool is_threat = false;  // the voice or weapon of a creature; softened while a nearer threat sounds
};

// Stops every started sound on this channel of this entity.
struct StoppedSound {
  std::int32_t entity = kNoEntity;
  int channel = 0;
};

// A sound that plays until the level ends. It repeats its loop; load it with Repeats::kAlways if its file may
// have none, or it plays once. The original rejects static sounds without a loop.
struct StaticSound {
  SoundPtr sound;
  math::Vec3 origin_world{0.0f};
  float volume = 1, attenuation = 1;  // see StartedSound
};

// The mixer applies the members in this order.
struct SoundEvents {
  bool stops_all = false;  // every sound ends: a new level, or a seek in a demo
  // If set, `ambients` replaces the ambient sounds. Index as in Scene::ambient_levels; null: no sound of that
  // kind.
  bool new_ambients = false;
  std::array<SoundPtr, kAmbients> ambients;
  std::vector<StaticSound> statics;
  std::vector<StartedSound> started;
  std::vector<StoppedSound> stopped;

  bool empty() const {
    return !stops_all && !new_ambients && statics.empty() && started.empty() && stopped.empty();
  }
  // Empties the lists but keeps their memory.
  void clear() {
    stops_all = new_ambients = false;
    ambients.fill(nullptr);
    statics.clear();
    started.clear();
    stopped.clear();
  }
};

}  // namespace temblor::audio
