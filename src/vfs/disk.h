// Reads files of the operating system, with size limits. All errors name the file.
#pragma once

#include <cstdint>
#include <filesystem>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::vfs {

// Default size limit, so that a hostile file cannot exhaust memory.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{256} << 20;

// Reads a whole file. Returns kNotFound, kIo, or kTooLarge for more than `max_bytes`.
base::Result<base::ByteVector> read_disk_file(const std::filesystem::path& path,
                                              std::uint64_t max_bytes = kMaxFileBytes);

// Reads `size` bytes at `offset`. Returns kIo if the file is too short.
base::Result<base::ByteVector> read_disk_range(const std::filesystem::path& path, std::uint64_t offset,
                                               std::uint64_t size);

// Returns the size of a regular file. Returns kNotFound, or kIo for a folder or device.
base::Result<std::uint64_t> disk_file_size(const std::filesystem::path& path);

}  // namespace temblor::vfs
