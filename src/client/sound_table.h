// The sounds of a level's precache list, and those that the client plays by itself: numbers and names become
// sounds that can be mixed.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "audio/sound.h"
#include "base/parallel_for.h"

namespace temblor::client {

// A sound that is missing or damaged is silent. That is noted once, when it would be heard for the first
// time: many a list has names that nobody ever plays.
class SoundTable {
 public:
  explicit SoundTable(const assets::Library& library) : library_(library) {}

  // `names` as in Game::sounds: [0] is none. Sounds of the level before that this one has too are kept.
  void begin_level(std::span<const std::string> names);
  // Loads and resamples all that are still to be loaded, so that none has to be later.
  void load_all(base::Jobs& jobs);

  // Null: silent, or a number past the list. What is not there yet is loaded now, which takes milliseconds.
  audio::SoundPtr sound(std::size_t number);
  audio::SoundPtr sound(const std::string& name);
  // The same, made to loop if it does not.
  audio::SoundPtr looped_sound(const std::string& name);

  // A line each, since the last time it was asked for.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  struct Loaded {
    audio::SoundPtr sound;  // null: silent
    std::string note;       // why, until it has been told
  };
  Loaded load(const std::string& name, audio::Repeats repeats) const;
  using Sounds = std::map<std::string, Loaded>;
  audio::SoundPtr find_or_load(Sounds& io_sounds, const std::string& name, audio::Repeats repeats);

  const assets::Library& library_;
  std::vector<std::string> names_;
  Sounds sounds_, looped_sounds_;
  std::vector<std::string> notes_;
};

}  // namespace temblor::client
