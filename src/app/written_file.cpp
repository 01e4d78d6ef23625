#include "app/written_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace temblor::app {
namespace {

base::Error cannot_write(const std::filesystem::path& path, const std::string& reason) {
  return {base::ErrorCode::kIo, "cannot be written (" + reason + "): choose another place with -o",
          path.string()};
}

}  // namespace

base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes) {
  std::filesystem::path beside = path;
  beside += ".new";
  std::error_code failure;
  {
    errno = 0;
    std::ofstream file(beside, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      const std::string reason = std::generic_category().message(errno);
      std::filesystem::remove(beside, failure);
      return cannot_write(path, reason);
    }
  }
  std::filesystem::rename(beside, path, failure);
  if (!failure) return base::Ok{};
  const std::string reason = failure.message();
  std::filesystem::remove(beside, failure);
  return cannot_write(path, reason);
}

}  // namespace temblor::app
