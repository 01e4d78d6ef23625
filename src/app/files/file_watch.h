// Tells when files change.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace temblor::app {

// A file as it was when one looked. To be had before the file is read, so that what was read is not older.
struct FileStamp {
  std::filesystem::path file;
  bool exists = false;
  std::filesystem::file_time_type written{};
  std::uintmax_t bytes = 0;
  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::filesystem::path& file);

class FileWatch {
 public:
  // Watches them from the time of their stamps on; what is watched already stays so from where it was. A file
  // that is not there is watched too; a folder changes when a file comes into it or goes.
  void add(const std::vector<FileStamp>& stamps);

  // Whether any file is another one than at the last change (or when it was added), and all have stood still
  // between two calls: an editor that is still writing is waited for. A file that goes away is no change, for
  // it may be about to be replaced; one that comes back is.
  bool has_changed();

  // Looks again and again until it has.
  void wait();

 private:
  struct Watched {
    FileStamp before, last;
  };
  std::map<std::filesystem::path, Watched> files_;
};

}  // namespace temblor::app
