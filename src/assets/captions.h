// Loads the captions of a game's sounds (formats/game/captions.h).
#pragma once

#include <string>
#include <vector>

#include "formats/game/captions.h"
#include "vfs/file_system.h"

namespace temblor::assets {

// Reads captions.txt of all game directories; later ones replace captions of earlier ones. Notes lines that
// cannot be read.
formats::Captions load_captions(const vfs::FileSystem& files, std::vector<std::string>& io_notes);

}  // namespace temblor::assets
