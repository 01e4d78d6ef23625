// Files that a program reads and writes itself (FRIK_FILE): all of them below data/ of the game folder, a few
// open at once, bounded in size.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::server {

enum class ScriptFileMode : int { kRead = 0, kAppend = 1, kWrite = 2 };

class ScriptFiles {
 public:
  static constexpr int kMaxOpen = 16;
  static constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20;
  // Of all that is written, as long as the object lives: no program fills a disk.
  static constexpr std::size_t kMaxWrittenBytes = std::size_t{256} << 20;
  static constexpr std::size_t kMaxNameChars = 128;

  // Reads a file of the game data by its name ("data/scores.txt"), from wherever it is mounted.
  using Reader = std::function<base::Result<base::ByteVector>(std::string_view name)>;

  ScriptFiles() = default;
  // `data_folder`: where files are written, and looked for first; made when the first one is. Empty: nothing
  // is written. `reader`: may be none.
  ScriptFiles(std::filesystem::path data_folder, Reader reader)
      : data_folder_(std::move(data_folder)), reader_(std::move(reader)) {}

  bool can_write() const { return !data_folder_.empty(); }

  // A handle; kNotFound for a file to read that is not there. `name` is relative to data/, may begin with
  // "data/", and is refused (kUsage) when it is absolute, has a part that begins with a dot (so none is
  // ".."), or holds other characters than letters, digits and "_-+=. /()[]!#$@,~".
  base::Result<int> open(std::string_view name, ScriptFileMode mode);
  // The other calls: kUsage for a handle that is not open, or open the other way.
  base::Status close(int handle);
  // The next line without its end; nothing at the end of the file. Valid until the file is closed.
  base::Result<std::optional<std::string_view>> read_line(int handle);
  // kTooLarge past the limits above; the file then stays as it was.
  base::Status write(int handle, std::string_view text);
  // All that are open; the first thing that went wrong.
  base::Status close_all();

 private:
  struct File {
    ScriptFileMode mode = ScriptFileMode::kRead;
    std::filesystem::path path{};
    std::string text{};  // all that is read; or what is still to be written
    std::size_t at = 0;  // read up to here; or bytes that the file has already
  };

  base::Result<File*> find(int handle);
  base::Result<std::string> read_all(const std::string& name) const;
  base::Status flush(File& io_file);

  std::filesystem::path data_folder_;
  Reader reader_;
  std::array<std::optional<File>, kMaxOpen> files_;
  std::size_t written_bytes_ = 0;
};

}  // namespace temblor::server
