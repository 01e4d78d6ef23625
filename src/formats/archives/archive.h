// Common parts of the archive formats (PAK, PK3): files to pack, and the rule for names that are safe to
// unpack.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/bytes.h"

namespace temblor::formats {

// A file to pack into an archive. `data` is borrowed, and must outlive the call that writes it.
struct ArchiveFile {
  std::string name;
  base::Bytes data;
};

// Returns whether a name is safe to unpack below a folder: a relative path with '/' separators, without '\',
// ':', control characters, and empty, ".", or ".." parts. So "/etc/passwd", "../x", and "c:x" are not.
bool is_contained_name(std::string_view name);

}  // namespace temblor::formats
