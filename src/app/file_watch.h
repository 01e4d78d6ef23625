// Tells when files change.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace temblor::app {

class FileWatch {
 public:
  // Watches them from now on; what is watched already stays so from where it was. A file that is not there
  // is watched too; a folder changes when a file comes into it or goes.
  void add(const std::vector<std::filesystem::path>& files);

  // Whether any file is another one than at the last change (or when it was added), and all have stood still
  // between two calls: an editor that is still writing is waited for. A file that goes away is no change, for
  // it may be about to be replaced; one that comes back is.
  bool has_changed();

  // Looks again and again until it has.
  void wait();

 private:
  struct State {
    bool exists = false;
    std::filesystem::file_time_type written{};
    std::uintmax_t bytes = 0;
    bool operator==(const State&) const = default;
  };
  static State state_of(const std::filesystem::path& file);

  struct Watched {
    State before, last;
  };
  std::map<std::filesystem::path, Watched> files_;
};

}  // namespace temblor::app
