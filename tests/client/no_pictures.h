// The pictures of a game that has none: only built-in placeholders.
#pragma once

#include <string>
#include <vector>

#include "assets/pictures.h"
#include "support/programs/temporary_folder.h"
#include "vfs/file_system.h"

namespace temblor::test {

inline const assets::Pictures& no_pictures() {
  static const assets::Pictures pictures = [] {
    const TemporaryFolder folder;
    folder.write("id1/empty.txt", base::ByteVector{});
    std::vector<std::string> notes;
    return assets::Pictures::load(vfs::FileSystem::open(folder.path()).value(), notes);
  }();
  return pictures;
}

}  // namespace temblor::test
