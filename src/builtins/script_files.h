// Files that game code reads and writes (FRIK_FILE). All of them are below data/ of the game folder; few may
// be open at once, and their sizes are bounded, so that a hostile program can neither read other files nor
// fill a disk.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::builtins {

enum class ScriptFileMode : int { kRead = 0, kAppend = 1, kWrite = 2 };

class ScriptFiles {
 public:
  static constexpr int kMaxOpen = 16;
  static constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20;
  // The sum of all that is written while the object lives.
  static constexpr std::size_t kMaxWrittenBytes = std::size_t{256} << 20;
  static constexpr std::size_t kMaxNameChars = 128;

  // Reads a file of the game data by its name ("data/scores.txt"), from wherever it is mounted.
  using Reader = std::function<base::Result<base::ByteVector>(std::string_view name)>;

  ScriptFiles() = default;
  // `data_folder`: where files are written, and searched for first; it is created with the first file. Empty:
  // nothing can be written. `reader` may be empty: then only the data folder is read.
  ScriptFiles(std::filesystem::path data_folder, Reader reader)
      : data_folder_(std::move(data_folder)), reader_(std::move(reader)) {}

  bool can_write() const { return !data_folder_.empty(); }

  // Opens a file and returns its handle. kNotFound: there is no such file to read. `name` is relative to
  // data/, and may begin with "data/". It is refused (kUsage) if it is absolute, has a part that begins with
  // a dot (as ".." does), or contains other characters than letters, digits and "_-+=. /()[]!#$@,~".
  base::Result<int> open(std::string_view name, ScriptFileMode mode);
  // The other functions return kUsage for a handle that is not open, or is open the other way.
  base::Status close(int handle);
  // The next line without its newline; empty at the end of the file. Valid until the file is closed.
  base::Result<std::optional<std::string_view>> read_line(int handle);
  // kTooLarge if this exceeds the limits above; the file then stays as it was.
  base::Status write(int handle, std::string_view text);
  // Closes all open files, and returns the first error.
  base::Status close_all();

 private:
  struct File {
    ScriptFileMode mode = ScriptFileMode::kRead;
    std::filesystem::path path{};
    std::string text{};  // the whole file, if it is read; else what is still to be written
    std::size_t at = 0;  // read up to here; else the number of bytes that the file already has
  };

  base::Result<File*> find(int handle);
  base::Result<std::string> read_all(const std::string& name) const;
  base::Status flush(File& io_file);

  std::filesystem::path data_folder_;
  Reader reader_;
  std::array<std::optional<File>, kMaxOpen> files_;
  std::size_t written_bytes_ = 0;
};

}  // namespace temblor::builtins
