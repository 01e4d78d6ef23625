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

base::Error cannot_write(const std::filesystem::path& path, const std::string& reason, Remedy remedy) {
  return {base::ErrorCode::kIo,
          fmt::format("cannot be written ({}){}", reason,
                      remedy == Remedy::kOtherOutput ? ": choose another place with -o" : ""),
          path.string()};
}

// The system's reason, where it cannot be written as a whole.
std::optional<std::string> write_bytes(const std::filesystem::path& path, base::Bytes bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? std::nullopt : std::optional(std::generic_category().message(errno));
}

// What a link stands for: the link stays.
std::filesystem::path place_of(const std::filesystem::path& path) {
  std::error_code failure;
  if (!std::filesystem::is_symlink(path, failure)) return path;
  std::filesystem::path place = std::filesystem::canonical(path, failure);
  return failure ? path : place;
}

}  // namespace

base::Result<FileChange> FileChange::replacement(const std::filesystem::path& path, base::Bytes bytes,
                                                 Remedy remedy) {
  FileChange change;
  change.remedy_ = remedy;
  change.path_ = path;
  std::error_code failure;
  // A device or a pipe holds nothing to be kept, and a file must not take its place.
  if (std::filesystem::is_other(path, failure)) {
    change.device_bytes_.emplace(bytes.begin(), bytes.end());
    return change;
  }
  change.place_ = place_of(path);
  // Two programs that write the same file at once must not write into each other's.
  change.beside_ = change.place_;
  change.beside_ += fmt::format(".{}.new", getpid());
  if (const auto reason = write_bytes(change.beside_, bytes)) return cannot_write(path, *reason, remedy);
  return change;
}

FileChange FileChange::removal(const std::filesystem::path& path, bool replaced) {
  FileChange change;
  change.path_ = path;
  change.place_ = replaced ? place_of(path) : path;
  return change;
}

FileChange::FileChange(FileChange&& other) noexcept {
  *this = std::move(other);
}

FileChange& FileChange::operator=(FileChange&& other) noexcept {
  path_.swap(other.path_);
  std::swap(remedy_, other.remedy_);
  place_.swap(other.place_);
  beside_.swap(other.beside_);
  device_bytes_.swap(other.device_bytes_);
  return *this;
}

FileChange::~FileChange() {
  std::error_code ignored;
  if (!beside_.empty()) std::filesystem::remove(beside_, ignored);
}

base::Status FileChange::put_in_place() {
  std::error_code failure;
  if (device_bytes_) {
    const auto reason = write_bytes(path_, *device_bytes_);
    return reason ? base::Status(cannot_write(path_, *reason, remedy_)) : base::Ok{};
  }
  if (beside_.empty())
    std::filesystem::remove(place_, failure);
  else
    std::filesystem::rename(beside_, place_, failure);
  if (failure) return cannot_write(path_, failure.message(), remedy_);
  beside_.clear();
  return base::Ok{};
}

base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes, Remedy remedy) {
  TRY(FileChange change, FileChange::replacement(path, bytes, remedy));
  return change.put_in_place();
}

}  // namespace temblor::app
