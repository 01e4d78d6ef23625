// Makes a level's textures drawable: kinds from their names, four mip levels each, animation sequences, and
// placeholders for missing ones.
#pragma once

#include <vector>

#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

// Returns one texture for each miptex, in the same order, and after them the placeholder for faces whose
// texture index is out of range. Moves the texels out of `io_miptexes`.
std::vector<Texture> make_textures(std::vector<formats::BspMiptex>& io_miptexes);

}  // namespace temblor::world
