#include "app/file_watch.h"

#include <chrono>
#include <system_error>
#include <thread>

namespace temblor::app {

void FileWatch::add(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) {
    const State now = state_of(file);
    files_.try_emplace(file, Watched{now, now});
  }
}

bool FileWatch::has_changed() {
  bool changed = false, stands_still = true;
  for (auto& [file, watched] : files_) {
    const State now = state_of(file);
    if (now != watched.last) stands_still = false;
    if (now.exists && now != watched.before) changed = true;
    watched.last = now;
  }
  if (!changed || !stands_still) return false;
  for (auto& [file, watched] : files_) watched.before = watched.last;
  return true;
}

void FileWatch::wait() {
  constexpr std::chrono::milliseconds kBetweenLooks{100};
  while (!has_changed()) std::this_thread::sleep_for(kBetweenLooks);
}

FileWatch::State FileWatch::state_of(const std::filesystem::path& file) {
  std::error_code failure;
  State state;
  const bool is_folder = std::filesystem::is_directory(file, failure);
  if (!is_folder) state.bytes = std::filesystem::file_size(file, failure);
  if (failure) return {};
  state.written = std::filesystem::last_write_time(file, failure);
  if (failure) return {};
  state.exists = true;
  return state;
}

}  // namespace temblor::app
