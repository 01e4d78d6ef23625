// What the archive formats (PAK, PK3) share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/bytes.h"

namespace temblor::formats {

// A file to put into an archive. `data` is not owned: it must outlive the call that writes it.
struct ArchiveFile {
  std::string name;
  base::Bytes data;
};

// Whether a file of that name, unpacked into a folder, stays inside it: relative, '/' between parts (no '\'
// and no ':'), no empty, "." or ".." part, no control characters.
bool is_contained_name(std::string_view name);

}  // namespace temblor::formats
