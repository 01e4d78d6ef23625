#include "server/save/autosave.h"

#include <algorithm>
#include <system_error>

namespace temblor::server {
namespace {

constexpr double kArrival_s = 0.5;    // until the player has settled on the floor
constexpr double kWorthSaving_s = 5;  // in the level; the menus ask for confirmation after as long
constexpr double kUnhurt_s = 3;
constexpr float kHealthDecay = 1;  // health above the maximum decays by 1: that is no damage

}  // namespace

void Autosave::begin_loaded(std::string_view name) {
  const bool is_own = std::find(kAutosaveNames.begin(), kAutosaveNames.end(), name) != kAutosaveNames.end();
  name_ = is_own ? name : std::string_view();
  was_saved_ = true;  // the save that was loaded
}

void Autosave::begin_level() {
  began_s_.reset();
  health_ = 0;
  was_saved_ = false;
  stands_ = true;
}

void Autosave::note_save(double now_s) {
  saved_s_ = now_s;
  was_saved_ = true;
}

void Autosave::watch(const Player& player, double now_s) {
  if (!began_s_) began_s_ = saved_s_ = hurt_s_ = now_s;
  if (player.health < health_ - kHealthDecay) hurt_s_ = now_s;
  health_ = player.health;
  stands_ = player.stands;
}

bool Autosave::is_due(double every_s, double now_s) const {
  // On arrival, a player who is under attack needs the save even more.
  if (!was_saved_) return began_s_ && now_s - *began_s_ >= kArrival_s && stands_;
  return now_s - saved_s_ >= every_s && stands_ && now_s - hurt_s_ >= kUnhurt_s;
}

bool Autosave::is_worth_saving(double now_s) const {
  return began_s_ && now_s - *began_s_ >= kWorthSaving_s;
}

// A file without a readable time counts as missing.
std::string Autosave::choose_name(const std::filesystem::path& folder) {
  if (!name_.empty()) return name_;
  std::optional<std::filesystem::file_time_type> oldest;
  for (const std::string_view name : kAutosaveNames) {
    std::error_code failure;
    const auto written = std::filesystem::last_write_time(folder / (std::string(name) + ".sav"), failure);
    if (failure) return name_ = name;
    if (oldest && written >= *oldest) continue;
    oldest = written;
    name_ = name;
  }
  return name_;
}

}  // namespace temblor::server
