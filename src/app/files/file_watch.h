// Detects changes of files by polling size and modification time. Polling works on every file system, also on
// network drives, and copes with editors that replace files instead of writing them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace temblor::app {

// State of a file at one moment. Take it before you read the file: then a later save is never missed.
struct FileStamp {
  std::filesystem::path file;
  bool exists = false;
  std::filesystem::file_time_type written{};
  std::uintmax_t bytes = 0;
  bool operator==(const FileStamp&) const = default;
};
// For a folder, `bytes` is 0 and `written` changes when an entry is added or removed.
FileStamp read_file_stamp(const std::filesystem::path& file);

class FileWatch {
 public:
  // Watches the files for changes since their stamps. Files that are already watched keep their older stamps.
  // A file may be missing; it changes when it appears.
  void add(const std::vector<FileStamp>& stamps);

  // Returns whether any file has changed since the last reported change (or since it was added) and no file
  // has changed between the last two calls, so that an editor can finish writing. A file that disappears is
  // not a change, because it may be about to be replaced; its reappearance is.
  bool has_changed();

  // Polls until has_changed().
  void wait();

 private:
  // Stamps at the last reported change, and at the last call.
  struct Watched {
    FileStamp before, last;
  };
  std::map<std::filesystem::path, Watched> files_;
};

}  // namespace temblor::app
