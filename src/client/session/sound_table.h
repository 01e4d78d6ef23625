// The sounds of a level's precache list, and those that the client plays by itself: numbers and names become
// sounds that can be mixed.
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

// Game code names whatever it likes, and a server may have any file played: over a limit, further sounds are
// silent until the next level, which is noted once.
struct SoundLimits {
  std::size_t ahead_samples = std::size_t{1} << 26;  // 256 MB loaded by the thread; the rest when it is heard
  std::size_t samples = std::size_t{1} << 27;        // 512 MB, but for the last one
  std::size_t names = std::size_t{1} << 14;
};

// A sound that is missing or damaged is silent. That is noted once, when it would be heard for the first
// time: many a list has names that nobody ever plays.
//
// A level's sounds are loaded on a thread of their own, so that it can be seen before. One that is asked for
// earlier is loaded there and then, so what is heard does not depend on that thread.
class SoundTable {
 public:
  explicit SoundTable(const assets::Library& library, const SoundLimits& limits = {})
      : library_(library), limits_(limits) {}
  ~SoundTable();
  SoundTable(const SoundTable&) = delete;
  SoundTable& operator=(const SoundTable&) = delete;

  // `names` as in Game::sounds: [0] is none. Sounds of the level before that this one has too are kept.
  void begin_level(std::span<const std::string> names);

  // Null: silent, or a number past the list. What is not there yet is loaded now, which takes milliseconds.
  audio::SoundPtr sound(std::size_t number);
  audio::SoundPtr sound(const std::string& name);
  // The same, made to loop if it does not.
  audio::SoundPtr looped_sound(const std::string& name);

  // How many sounds of the level are there.
  std::size_t loaded_count() const;

  // A line each, since the last time it was asked for.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  struct Loaded {
    audio::SoundPtr sound;  // null: silent
    std::string note;       // why, until it has been told
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
  mutable std::mutex mutex_;  // of the two maps and what is in them; held for moments
  Sounds sounds_, looped_sounds_;
  std::size_t samples_ = 0;  // of all of both
  bool has_noted_limit_ = false;
  std::vector<std::string> notes_;
  std::atomic<bool> stops_{false};
  std::thread loader_;
};

}  // namespace temblor::client
