#include "app/files/atomic_write.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace temblor::app {
namespace {

// Writes the file. Returns the system's error message if any byte could not be written.
std::optional<std::string> write_bytes(const std::filesystem::path& path, base::Bytes bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? std::nullopt : std::optional(std::generic_category().message(errno));
}

base::Status make_parent_folder(const std::filesystem::path& path, Remedy remedy) {
  const std::filesystem::path folder = path.parent_path();
  std::error_code failure;
  if (remedy != Remedy::kNone || folder.empty() || std::filesystem::is_directory(folder, failure))
    return base::Ok{};
  std::filesystem::create_directories(folder, failure);
  return failure ? base::Status(make_write_error(path, failure.message(), remedy)) : base::Ok{};
}

// Returns the target of a symbolic link, so that the link itself is kept; any other path unchanged.
std::filesystem::path resolve_link(const std::filesystem::path& path) {
  std::error_code failure;
  if (!std::filesystem::is_symlink(path, failure)) return path;
  std::filesystem::path place = std::filesystem::canonical(path, failure);
  return failure ? path : place;
}

}  // namespace

base::Error make_write_error(const std::filesystem::path& path, const std::string& reason, Remedy remedy) {
  const std::filesystem::path folder = path.parent_path();
  const bool has_output = remedy == Remedy::kOtherOutput;
  std::error_code ignored;
  if (has_output && !folder.empty() && !std::filesystem::is_directory(folder, ignored))
    return {base::ErrorCode::kIo,
            fmt::format("the folder {} does not exist; create it, or choose another output with -o",
                        folder.string()),
            path.string()};
  return {base::ErrorCode::kIo,
          fmt::format("cannot write ({}){}", reason, has_output ? "; choose another output with -o" : ""),
          path.string()};
}

base::Result<FileChange> FileChange::replacement(const std::filesystem::path& path, base::Bytes bytes,
                                                 Remedy remedy) {
  FileChange change;
  change.remedy_ = remedy;
  change.path_ = path;
  std::error_code failure;
  // A device or a pipe has no contents to protect, and a regular file must not replace it.
  if (std::filesystem::is_other(path, failure)) {
    change.device_bytes_.emplace(bytes.begin(), bytes.end());
    return change;
  }
  change.target_ = resolve_link(path);
  TRY_STATUS(make_parent_folder(change.target_, remedy));
  // The process id keeps two programs that write the same file from sharing a temporary file.
  change.temporary_ = change.target_;
  change.temporary_ += fmt::format(".{}.new", getpid());
  if (const auto reason = write_bytes(change.temporary_, bytes))
    return make_write_error(path, *reason, remedy);
  return change;
}

FileChange FileChange::removal(const std::filesystem::path& path, bool replaced) {
  FileChange change;
  change.path_ = path;
  change.target_ = replaced ? resolve_link(path) : path;
  return change;
}

FileChange::FileChange(FileChange&& other) noexcept {
  *this = std::move(other);
}

// Swaps, so that the other object removes this one's temporary file when it is destroyed.
FileChange& FileChange::operator=(FileChange&& other) noexcept {
  path_.swap(other.path_);
  std::swap(remedy_, other.remedy_);
  target_.swap(other.target_);
  temporary_.swap(other.temporary_);
  device_bytes_.swap(other.device_bytes_);
  return *this;
}

FileChange::~FileChange() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

// A removal has no temporary file, and a device only bytes.
base::Status FileChange::commit() {
  std::error_code failure;
  if (device_bytes_) {
    const auto reason = write_bytes(path_, *device_bytes_);
    return reason ? base::Status(make_write_error(path_, *reason, remedy_)) : base::Ok{};
  }
  if (temporary_.empty())
    std::filesystem::remove(target_, failure);
  else
    std::filesystem::rename(temporary_, target_, failure);
  if (failure) return make_write_error(path_, failure.message(), remedy_);
  temporary_.clear();
  return base::Ok{};
}

base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes, Remedy remedy) {
  TRY(FileChange change, FileChange::replacement(path, bytes, remedy));
  return change.commit();
}

}  // namespace temblor::app
