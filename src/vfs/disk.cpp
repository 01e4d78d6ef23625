#include "vfs/disk.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace temblor::vfs {

base::Result<std::uint64_t> disk_file_size(const std::filesystem::path& path) {
  const auto failed = [&](base::ErrorCode code, const std::string& what) {
    return base::Error{code, what, path.string()};
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    return failed(base::ErrorCode::kNotFound, "no such file");
  if (error) return failed(base::ErrorCode::kIo, error.message());
  if (!std::filesystem::is_regular_file(status)) return failed(base::ErrorCode::kIo, "not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return failed(base::ErrorCode::kIo, error.message());
  return std::uint64_t{size};
}

base::Result<base::ByteVector> read_disk_range(const std::filesystem::path& path, std::uint64_t offset,
                                               std::uint64_t size) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return base::Error{base::ErrorCode::kIo, "cannot be opened for reading", path.string()};
  file.seekg(static_cast<std::streamoff>(offset));
  base::ByteVector bytes(size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file)
    return base::Error{base::ErrorCode::kIo,
                       fmt::format("{} bytes at offset {} cannot be read", size, offset), path.string()};
  return bytes;
}

base::Result<base::ByteVector> read_disk_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  TRY(const std::uint64_t size, disk_file_size(path));
  if (size > max_bytes)
    return base::Error{base::ErrorCode::kTooLarge, fmt::format("{} bytes, the limit is {}", size, max_bytes),
                       path.string()};
  return read_disk_range(path, 0, size);
}

}  // namespace temblor::vfs
