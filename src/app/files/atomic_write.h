// Atomic file replacement (POSIX).
//
// The bytes are written to FILE.PID.new in the same folder, which is then renamed to FILE. rename() is
// atomic: other programs see the old file or the new one, never a part, and if the disk is full the old file
// stays.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// Advice in error messages: kOtherOutput suggests another -o; kNone is for files whose name the user did not
// choose.
enum class Remedy { kOtherOutput, kNone };

// Returns the kIo error for a file that cannot be written: its name, the system's reason, and the remedy. For
// an output in a folder that does not exist, it says so instead.
base::Error make_write_error(const std::filesystem::path& path, const std::string& reason, Remedy remedy);

// Replaces or creates a file atomically. If several programs write it at once, the last rename wins. A
// symbolic link is kept and its target replaced; a device or a pipe is written to directly. The folder of a
// file is made only with Remedy::kNone, because a misspelled folder of an output would go unnoticed. Errors
// are kIo and name the file.
base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes,
                          Remedy remedy = Remedy::kOtherOutput);

// The same in two steps, for files that belong together: prepare all of them, which may fail for lack of
// space or permission, then commit one after the other, which rarely fails.
class FileChange {
 public:
  // Writes the bytes to the temporary file. Bytes for a device are kept in memory until commit().
  static base::Result<FileChange> replacement(const std::filesystem::path& path, base::Bytes bytes,
                                              Remedy remedy = Remedy::kOtherOutput);
  // Removes the file; not an error if it does not exist. For a symbolic link, removes the target if a later
  // change replaces it (`replaced`), otherwise the link.
  static FileChange removal(const std::filesystem::path& path, bool replaced = false);

  FileChange(FileChange&& other) noexcept;
  FileChange& operator=(FileChange&& other) noexcept;
  // Removes the temporary file if commit() was not called.
  ~FileChange();

  // Makes the change visible. Call once.
  base::Status commit();

 private:
  FileChange() = default;

  Remedy remedy_ = Remedy::kOtherOutput;
  // The path as given, for messages, and with links resolved.
  std::filesystem::path path_, target_;
  // The temporary file; empty: none.
  std::filesystem::path temporary_;
  // The bytes for a device or a pipe, which cannot be replaced.
  std::optional<base::ByteVector> device_bytes_;
};

}  // namespace temblor::app
