#include "client/sound_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::client {

SoundTable::Loaded SoundTable::load(const std::string& name, audio::Repeats repeats) const {
  base::Result<formats::Wav> wav = library_.sound(name);
  if (!wav.ok()) return {nullptr, fmt::format("{}; it stays silent", wav.error().message())};
  base::Result<audio::SoundPtr> sound = audio::make_sound(*wav, name, repeats).with_file("sound/" + name);
  if (!sound.ok()) return {nullptr, fmt::format("{}; it stays silent", sound.error().message())};
  return {std::move(sound).value(), {}};
}

audio::SoundPtr SoundTable::find_or_load(Sounds& io_sounds, const std::string& name, audio::Repeats repeats) {
  auto found = io_sounds.find(name);
  if (found == io_sounds.end()) found = io_sounds.emplace(name, load(name, repeats)).first;
  Loaded& loaded = found->second;
  if (!loaded.note.empty()) notes_.push_back(std::exchange(loaded.note, {}));
  return loaded.sound;
}

void SoundTable::begin_level(std::span<const std::string> names) {
  names_.assign(names.begin(), names.end());
  std::erase_if(sounds_, [&](const auto& entry) {
    // What is missing is kept too, so that it is noted once a game and not once a level.
    return entry.second.sound != nullptr &&
           std::find(names_.begin(), names_.end(), entry.first) == names_.end();
  });
}

void SoundTable::load_all(base::Jobs& jobs) {
  std::vector<std::string> wanted;
  for (const std::string& name : names_)
    if (!name.empty() && !sounds_.contains(name) &&
        std::find(wanted.begin(), wanted.end(), name) == wanted.end())
      wanted.push_back(name);
  std::vector<Loaded> loaded(wanted.size());
  jobs.parallel_for(wanted.size(),
                    [&](std::size_t i) { loaded[i] = load(wanted[i], audio::Repeats::kAsTheFileSays); });
  for (std::size_t i = 0; i < wanted.size(); ++i) sounds_.emplace(wanted[i], std::move(loaded[i]));
}

audio::SoundPtr SoundTable::sound(std::size_t number) {
  if (number >= names_.size() || names_[number].empty()) return nullptr;
  return sound(names_[number]);
}

audio::SoundPtr SoundTable::sound(const std::string& name) {
  return find_or_load(sounds_, name, audio::Repeats::kAsTheFileSays);
}

audio::SoundPtr SoundTable::looped_sound(const std::string& name) {
  return find_or_load(looped_sounds_, name, audio::Repeats::kAlways);
}

}  // namespace temblor::client
