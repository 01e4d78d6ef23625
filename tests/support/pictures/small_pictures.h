// The 2D art of a game, made in code: gfx.wad and gfx/*.lmp with every picture of a stock game. Numbers,
// letters, and a few signs are readable; all other pictures are beveled plates with their names.
#pragma once

#include "support/programs/temporary_folder.h"

namespace temblor::test {

// Writes the art to the game folder id1, in the colors of artgen::make_palette().
void write_small_pictures(const TemporaryFolder& folder);

}  // namespace temblor::test
