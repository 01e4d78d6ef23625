#include "client/session/sound_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text.h"

namespace temblor::client {
namespace {

std::size_t count_samples(const audio::SoundPtr& sound) {
  return sound ? sound->samples.size() : 0;
}

// Names that differ only in case or in the direction of slashes are the same file.
std::string normalize_file_name(std::string_view sound) {
  std::string name = base::to_lower(sound);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

}  // namespace

SoundTable::~SoundTable() {
  stop_loading();
}

// Ends the thread; waits at most for the file that it is loading.
void SoundTable::stop_loading() {
  stops_ = true;
  if (loader_.joinable()) loader_.join();
  stops_ = false;
}

SoundTable::Loaded SoundTable::load(const std::string& name, audio::Repeats repeats) const {
  base::Result<formats::Wav> wav = library_.sound(name);
  if (!wav.ok()) return {nullptr, fmt::format("{}. The sound will be silent", wav.error().message())};
  base::Result<audio::SoundPtr> sound = audio::make_sound(*wav, name, repeats).with_file("sound/" + name);
  if (!sound.ok()) return {nullptr, fmt::format("{}. The sound will be silent", sound.error().message())};
  return {std::move(sound).value(), {}};
}

// Files are loaded without the lock, so that a slow file does not stop the other thread.
audio::SoundPtr SoundTable::find_or_load(Sounds& io_sounds, const std::string& name, audio::Repeats repeats) {
  std::unique_lock lock(mutex_);
  auto found = io_sounds.find(name);
  if (found == io_sounds.end()) {
    if (is_full()) {
      if (!std::exchange(has_noted_limit_, true))
        notes_.push_back(
            fmt::format("sound/{}: too many sounds ({} loaded, {} MB). This and further ones will be silent",
                        base::printable(name), sounds_.size(), (samples_ * sizeof(float)) >> 20));
      return nullptr;
    }
    lock.unlock();
    Loaded loaded = load(name, repeats);
    lock.lock();
    // If the other thread has loaded it meanwhile, both results are equal.
    const auto [place, is_new] = io_sounds.emplace(name, std::move(loaded));
    found = place;
    if (is_new) samples_ += count_samples(found->second.sound);
  }
  Loaded& loaded = found->second;
  if (!loaded.note.empty()) notes_.push_back(std::exchange(loaded.note, {}));
  return loaded.sound;
}

// Loads in the order of the list: game code names weapons first, and they are likely to be heard first.
void SoundTable::load_ahead(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (stops_) return;
    {
      const std::lock_guard lock(mutex_);
      if (samples_ >= limits_.ahead_samples || is_full()) return;
      if (name.empty() || sounds_.contains(name)) continue;
    }
    Loaded loaded = load(name, audio::Repeats::kAsInFile);
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = sounds_.emplace(name, std::move(loaded));
    if (is_new) samples_ += count_samples(place->second.sound);
  }
}

// The thread has ended before the lists change, so they need no lock here.
void SoundTable::begin_level(std::span<const std::string> names) {
  stop_loading();
  names_.clear();
  // Names that differ only in case or slashes are the same file.
  for (const std::string& name : names) names_.push_back(normalize_file_name(name));
  const std::set<std::string> wanted_names(names_.begin(), names_.end());
  std::erase_if(sounds_, [&](const auto& entry) { return !wanted_names.contains(entry.first); });
  samples_ = 0;
  for (const Sounds* sounds : {&sounds_, &looped_sounds_})
    for (const auto& [name, loaded] : *sounds) samples_ += count_samples(loaded.sound);
  has_noted_limit_ = false;
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
  return find_or_load(sounds_, name, audio::Repeats::kAsInFile);
}

audio::SoundPtr SoundTable::looped_sound(const std::string& name) {
  return find_or_load(looped_sounds_, name, audio::Repeats::kAlways);
}

}  // namespace temblor::client
