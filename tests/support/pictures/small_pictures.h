// The 2-D art of a game, made in code: gfx.wad and gfx/*.lmp, every picture that a stock game has. Numbers,
// letters and a few signs can be read; all other pictures are bevelled plates with what their names say.
#pragma once

#include "support/programs/temporary_folder.h"

namespace temblor::test {

// Into the game folder id1. In the colors of artgen::make_palette().
void write_small_pictures(const TemporaryFolder& folder);

}  // namespace temblor::test
