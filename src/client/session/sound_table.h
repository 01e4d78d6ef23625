// The sounds of a level's precache list, and those that the client plays itself. Translates numbers and names
// of messages to sounds for the mixer (audio/sound.h).
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "audio/sound.h"

namespace temblor::client {

// Limits against servers that name huge numbers of sounds. Above a limit, further sounds are silent until the
// next level, which is reported once.
struct SoundLimits {
  // Samples (floats) that the thread loads ahead, 256 MB; the rest is loaded on first use.
  std::size_t ahead_samples = std::size_t{1} << 26;
  // Samples in all, 512 MB; the last sound may exceed it.
  std::size_t samples = std::size_t{1} << 27;
  std::size_t names = std::size_t{1} << 14;
};

// Missing and damaged sounds are silent. Each is reported once, when it would first be heard: many lists have
// names that are never played.
//
// A thread loads a level's sounds ahead, so that the game starts without waiting. A sound that is needed
// earlier is loaded at once by the caller, so what is heard does not depend on the thread. All public
// functions must be called from one thread.
class SoundTable {
 public:
  explicit SoundTable(const assets::Library& library, const SoundLimits& limits = {})
      : library_(library), limits_(limits) {}
  ~SoundTable();
  SoundTable(const SoundTable&) = delete;
  SoundTable& operator=(const SoundTable&) = delete;

  // Starts loading the sounds. `names` is Game::sounds: [0] is none. Keeps the sounds that the last level had
  // too.
  void begin_level(std::span<const std::string> names);

  // Returns the sound; null for a silent one or a number past the list. Loads the sound now if necessary,
  // which takes milliseconds. `name`: below "sound/".
  audio::SoundPtr sound(std::size_t number);
  audio::SoundPtr sound(const std::string& name);
  // Returns the sound as one that loops even if the file does not.
  audio::SoundPtr looped_sound(const std::string& name);

  // How many of the level's sounds are loaded.
  std::size_t loaded_count() const;

  // Problems since the last call, a line each.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  struct Loaded {
    audio::SoundPtr sound;  // null if silent
    std::string note;       // why, until it is reported
  };
  using Sounds = std::map<std::string, Loaded>;

  Loaded load(const std::string& name, audio::Repeats repeats) const;
  audio::SoundPtr find_or_load(Sounds& io_sounds, const std::string& name, audio::Repeats repeats);
  void load_ahead(const std::vector<std::string>& names);
  void stop_loading();
  bool is_full() const { return samples_ >= limits_.samples || sounds_.size() >= limits_.names; }

  const assets::Library& library_;
  SoundLimits limits_;
  std::vector<std::string> names_;
  mutable std::mutex mutex_;  // guards both maps and their contents; held for moments
  Sounds sounds_, looped_sounds_;
  std::size_t samples_ = 0;  // in both maps
  bool has_noted_limit_ = false;
  std::vector<std::string> notes_;
  std::atomic<bool> stops_{false};
  std::thread loader_;
};

}  // namespace temblor::client
