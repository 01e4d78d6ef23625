// Textures that a level names, but keeps in WADs: Half-Life's levels (version 30) list the WADs in
// worldspawn's key "wad".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assets/level/additions.h"
#include "formats/levels/bsp.h"

namespace temblor::assets {

// Reads a WAD by its file name without folders, in lower case; nullopt: there is none.
using WadReader = AdditionReader;

// Returns the file names, without folders, of the WADs that an entity text names, in order. Entries are paths
// of the mapper's computer, separated by semicolons, with slashes of either kind.
std::vector<std::string> list_wads(std::string_view entity_text);

// Fills in the textures of a level of version 30 that have a name but no texels; does nothing for other
// levels. The first WAD that has a name counts. Notes WADs that are needed but missing or damaged, and
// textures that cannot be read.
void fill_wad_textures(const WadReader& read, formats::Bsp& io_bsp, std::vector<std::string>& io_notes);

}  // namespace temblor::assets
