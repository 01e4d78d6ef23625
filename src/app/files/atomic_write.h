// Files that are there whole or not at all. POSIX.
#pragma once

#include <filesystem>
#include <optional>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// What an error says can be done: kNone where the player has not chosen the place.
enum class Remedy { kOtherOutput, kNone };

// Written beside `path` under another name, then renamed: whoever reads it meanwhile sees the old file or the
// new one, and a full disk leaves the old one. Of several programs that write it at once, one has the last
// word. What a symbolic link stands for is replaced, not the link; a device or a pipe is written to. Errors
// name the file.
base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes,
                          Remedy remedy = Remedy::kOtherOutput);

// The same in two steps, for files that belong together: all that can fail for want of room or rights is done
// for each of them before the first is put in place.
class FileChange {
 public:
  // Writes the bytes beside the file. Those for a device are kept until put_in_place.
  static base::Result<FileChange> replacement(const std::filesystem::path& path, base::Bytes bytes,
                                              Remedy remedy = Remedy::kOtherOutput);
  // No error where there is no such file. Of a symbolic link what it stands for goes if that is `replaced`
  // later, else the link.
  static FileChange removal(const std::filesystem::path& path, bool replaced = false);

  FileChange(FileChange&& other) noexcept;
  FileChange& operator=(FileChange&& other) noexcept;
  ~FileChange();  // takes away what lies beside the file

  // Once.
  base::Status put_in_place();

 private:
  FileChange() = default;

  Remedy remedy_ = Remedy::kOtherOutput;
  std::filesystem::path path_;    // as it is called in messages
  std::filesystem::path place_;   // where it lies
  std::filesystem::path beside_;  // what is renamed; empty: nothing
  std::optional<base::ByteVector> device_bytes_;
};

}  // namespace temblor::app
