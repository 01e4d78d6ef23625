// Reads a file that may be newer than the list of the game folders' files, because its author has just made
// it.
#pragma once

#include <string>

#include "base/bytes.h"
#include "base/result.h"
#include "vfs/file_system.h"

namespace temblor::assets {

// Reads the file of the game folders. If it is not on their list, reads a loose file from the last folder
// that has one now. Empty if there is none.
base::Result<base::ByteVector> read_new_file(const vfs::FileSystem& files, const std::string& name);

}  // namespace temblor::assets
