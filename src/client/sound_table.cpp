#include "client/sound_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::client {

SoundTable::~SoundTable() {
  stop_loading();
}

void SoundTable::stop_loading() {
  stops_ = true;
  if (loader_.joinable()) loader_.join();
  stops_ = false;
}

SoundTable::Loaded SoundTable::load(const std::string& name, audio::Repeats repeats) const {
  base::Result<formats::Wav> wav = library_.sound(name);
  if (!wav.ok()) return {nullptr, fmt::format("{}; it stays silent", wav.error().message())};
  base::Result<audio::SoundPtr> sound = audio::make_sound(*wav, name, repeats).with_file("sound/" + name);
  if (!sound.ok()) return {nullptr, fmt::format("{}; it stays silent", sound.error().message())};
  return {std::move(sound).value(), {}};
}

audio::SoundPtr SoundTable::find_or_load(Sounds& io_sounds, const std::string& name, audio::Repeats repeats) {
  std::unique_lock lock(mutex_);
  auto found = io_sounds.find(name);
  if (found == io_sounds.end()) {
    lock.unlock();
    Loaded loaded = load(name, repeats);
    lock.lock();
    // Whoever was first, it is the same.
    found = io_sounds.emplace(name, std::move(loaded)).first;
  }
  Loaded& loaded = found->second;
  if (!loaded.note.empty()) notes_.push_back(std::exchange(loaded.note, {}));
  return loaded.sound;
}

// In the order of the list: what game code names first (the weapons) is likely to be heard first.
void SoundTable::load_ahead(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (stops_) return;
    {
      const std::lock_guard lock(mutex_);
      if (name.empty() || sounds_.contains(name)) continue;
    }
    Loaded loaded = load(name, audio::Repeats::kAsTheFileSays);
    const std::lock_guard lock(mutex_);
    sounds_.emplace(name, std::move(loaded));
  }
}

void SoundTable::begin_level(std::span<const std::string> names) {
  stop_loading();
  names_.assign(names.begin(), names.end());
  std::erase_if(sounds_, [&](const auto& entry) {
    // What is missing is kept too, so that it is noted once a game and not once a level.
    return entry.second.sound != nullptr &&
           std::find(names_.begin(), names_.end(), entry.first) == names_.end();
  });
  loader_ = std::thread([this, wanted = names_] { load_ahead(wanted); });
}

std::size_t SoundTable::loaded_count() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
      names_.begin(), names_.end(), [&](const std::string& name) { return sounds_.contains(name); }));
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
