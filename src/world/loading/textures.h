// A level's textures made drawable: kinds from names, all four mip levels there, animations joined.
#pragma once

#include <vector>

#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

// One texture for each of the level's, in the same order, and a missing one behind them, for faces whose
// texture number is out of range. Takes the texels out of `io_miptexes`.
std::vector<Texture> make_textures(std::vector<formats::BspMiptex>& io_miptexes);

}  // namespace temblor::world
