#include "client/sound_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text.h"

namespace temblor::client {
namespace {

// 256 MB: game code names whatever it likes. The rest is loaded when it is heard.
constexpr std::size_t kMostLoadedAhead_samples = std::size_t{1} << 26;

std::string file_name_of(std::string_view sound) {
  std::string name = base::to_lower(sound);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

}  // namespace

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
  std::size_t samples = 0;
  for (const std::string& name : names) {
    if (stops_) return;
    {
      const std::lock_guard lock(mutex_);
      if (name.empty() || sounds_.contains(name)) continue;
    }
    Loaded loaded = load(name, audio::Repeats::kAsTheFileSays);
    samples += loaded.sound ? loaded.sound->samples.size() : 0;
    if (samples > kMostLoadedAhead_samples) return;
    const std::lock_guard lock(mutex_);
    sounds_.emplace(name, std::move(loaded));
  }
}

void SoundTable::begin_level(std::span<const std::string> names) {
  stop_loading();
  names_.clear();
  // Written in another way, it is the same file.
  for (const std::string& name : names) names_.push_back(file_name_of(name));
  const std::set<std::string> wanted_names(names_.begin(), names_.end());
  std::erase_if(sounds_, [&](const auto& entry) { return !wanted_names.contains(entry.first); });
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
