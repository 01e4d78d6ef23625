// Reading files of the operating system, bounded.
#pragma once

#include <cstdint>
#include <filesystem>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::vfs {

// A file over this is kTooLarge: a hostile one must not fill the memory.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{256} << 20;

// A file, whole, of at most `max_bytes`. kNotFound, kIo, kTooLarge; the error names the file.
base::Result<base::ByteVector> read_disk_file(const std::filesystem::path& path,
                                              std::uint64_t max_bytes = kMaxFileBytes);

// `size` bytes at `offset`. kIo when the file ends before; the error names the file.
base::Result<base::ByteVector> read_disk_range(const std::filesystem::path& path, std::uint64_t offset,
                                               std::uint64_t size);

// The size of an ordinary file; kNotFound, or kIo for a folder or a device; the error names it.
base::Result<std::uint64_t> disk_file_size(const std::filesystem::path& path);

}  // namespace temblor::vfs
