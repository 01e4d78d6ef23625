// What is to be heard: how things are at a moment (Scene), and what has happened (SoundEvents). The mixer's
// whole input, but for music.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "audio/sound.h"
#include "math/vec.h"

namespace temblor::audio {

struct Listener {
  math::Vec3 origin_world{0.0f};
  math::Vec3 right{0, -1, 0};  // of unit length
  std::int32_t entity = 0;     // what it does is heard in full, in both ears
  bool underwater = false;
};

// Sound of the place where the listener is, from everywhere: water, sky, slime, lava.
constexpr std::size_t kAmbients = 4;

struct Volumes {
  float sounds = 0.7f;           // 0 to 1
  float ambient = 0.3f;          // 0 to 1: of the levels that leaves have
  float music = 1;               // 0 to 1
  float muffled_underwater = 0;  // 0: as in air, to 1: dull
};

struct Scene {
  Listener listener;
  std::array<std::uint8_t, kAmbients> ambient_levels{};  // 0 to 255, as leaves have them
  Volumes volumes;
};

// Its entity of a sound that is nobody's.
constexpr std::int32_t kNoEntity = -1;
// The channel that takes the place of whatever its entity plays; one that takes no place at all; any other
// number takes that of the same entity and number.
constexpr int kAnyChannel = -1, kFreeChannel = 0;

struct StartedSound {
  SoundPtr sound;
  std::int32_t entity = kNoEntity;
  int channel = kFreeChannel;
  math::Vec3 origin_world{0.0f};
  float volume = 1;       // 0 to 1
  float attenuation = 1;  // silent 1000 units / attenuation away; 0: the same everywhere
};

struct StoppedSound {
  std::int32_t entity = kNoEntity;
  int channel = 0;
};

// Goes on until the level ends: its loop, or all of it if it has none.
struct StaticSound {
  SoundPtr sound;
  math::Vec3 origin_world{0.0f};
  float volume = 1, attenuation = 1;  // as of StartedSound
};

// In the order in which the mixer takes them.
struct SoundEvents {
  bool begins_anew = false;  // all that sounds ends: another level, another time
  // Where they change: by place in Scene::ambient_levels; null: no sound of that kind.
  bool new_ambients = false;
  std::array<SoundPtr, kAmbients> ambients;
  std::vector<StaticSound> statics;
  std::vector<StartedSound> started;
  std::vector<StoppedSound> stopped;

  bool empty() const {
    return !begins_anew && !new_ambients && statics.empty() && started.empty() && stopped.empty();
  }
  // Keeps the memory.
  void clear() {
    begins_anew = new_ambients = false;
    ambients.fill(nullptr);
    statics.clear();
    started.clear();
    stopped.clear();
  }
};

}  // namespace temblor::audio
