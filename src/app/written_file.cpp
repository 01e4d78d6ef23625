#include "app/written_file.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>

namespace temblor::app {
namespace {

base::Error cannot_write(const std::filesystem::path& path, const std::string& reason) {
  return {base::ErrorCode::kIo, "cannot be written (" + reason + "): choose another place with -o",
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

base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes) {
  std::error_code failure;
  // A device or a pipe holds nothing to be kept, and a file must not take its place.
  if (std::filesystem::is_other(path, failure)) {
    const auto reason = write_bytes(path, bytes);
    return reason ? base::Status(cannot_write(path, *reason)) : base::Ok{};
  }
  const std::filesystem::path place = place_of(path);
  // Two programs that write the same file at once must not write into each other's.
  std::filesystem::path beside = place;
  beside += "." + std::to_string(getpid()) + ".new";
  if (const auto reason = write_bytes(beside, bytes)) {
    std::filesystem::remove(beside, failure);
    return cannot_write(path, *reason);
  }
  std::filesystem::rename(beside, place, failure);
  if (!failure) return base::Ok{};
  const std::string reason = failure.message();
  std::filesystem::remove(beside, failure);
  return cannot_write(path, reason);
}

}  // namespace temblor::app
