// Files that are there whole or not at all. POSIX.
#pragma once

#include <filesystem>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// Written beside `path` under another name, then renamed: whoever reads it meanwhile sees the old file or the
// new one, and a full disk leaves the old one. Of several programs that write it at once, one has the last
// word. What a symbolic link stands for is replaced, not the link; a device or a pipe is written to. Errors
// name the file and say what to do.
base::Status replace_file(const std::filesystem::path& path, base::Bytes bytes);

}  // namespace temblor::app
