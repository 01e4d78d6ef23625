// Textures of a level with palettes of their own (version 30).
#pragma once

#include "formats/images/palette.h"
#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::assets {

// Adds the colors of such textures, except for those that have colors already and those whose palette is the
// game's. In a texture whose name begins with '{', index 255 is clear.
void add_own_palettes(const formats::Palette& game_palette, const formats::Bsp& bsp,
                      world::ColoredTextures& io_textures);

}  // namespace temblor::assets
