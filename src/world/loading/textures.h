// Makes a level's textures drawable: kinds from their names, four mip levels each, animation sequences, and
// placeholders for missing ones.
#pragma once

#include <vector>

#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

// Half-Life's levels mark liquids also with '!', and may contain faces that are never drawn.
enum class NameRules { kQuake, kHalfLife };

// Returns one texture for each miptex, in the same order, and after them the placeholder for faces whose
// texture index is out of range. Moves the texels out of `io_miptexes` and `io_colored` (make_level).
std::vector<Texture> make_textures(std::vector<formats::BspMiptex>& io_miptexes, ColoredTextures& io_colored,
                                   NameRules names);

}  // namespace temblor::world
