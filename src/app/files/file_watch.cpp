#include "app/files/file_watch.h"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace temblor::app {

// A file that disappears between two calls counts as missing.
FileStamp read_file_stamp(const std::filesystem::path& file) {
  std::error_code failure;
  FileStamp stamp{file};
  const bool is_folder = std::filesystem::is_directory(file, failure);
  if (!is_folder) stamp.bytes = std::filesystem::file_size(file, failure);
  if (failure) return {file};
  stamp.written = std::filesystem::last_write_time(file, failure);
  if (failure) return {file};
  stamp.exists = true;
  return stamp;
}

void FileWatch::add(const std::vector<FileStamp>& stamps) {
  for (const FileStamp& stamp : stamps) files_.try_emplace(stamp.file, Watched{stamp, stamp});
}

// A change is reported only when two consecutive looks see the same files, because editors write in several
// steps.
bool FileWatch::has_changed() {
  bool changed = false, is_stable = true;
  for (auto& [file, watched] : files_) {
    FileStamp now = read_file_stamp(file);
    if (now != watched.last) is_stable = false;
    if (now.exists && now != watched.before) changed = true;
    watched.last = std::move(now);
  }
  if (!changed || !is_stable) return false;
  for (auto& [file, watched] : files_) watched.before = watched.last;
  return true;
}

void FileWatch::wait() {
  constexpr std::chrono::milliseconds kBetweenLooks{100};
  while (!has_changed()) std::this_thread::sleep_for(kBetweenLooks);
}

}  // namespace temblor::app
