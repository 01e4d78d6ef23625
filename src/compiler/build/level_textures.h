// Between the names that sides have and the textures that a level holds.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "compiler/texture_set.h"
#include "formats/levels/bsp.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Of the sides that are drawn.
std::vector<std::string_view> texture_names(const formats::Map& map);

// In texels; 64 x 64 for what the set has not.
math::Vec2d texture_size_of(const TextureSet& set, std::string_view name);

// The level's first `own_textures`, known by their names, become those of the set; then follow the other
// frames of their animations, in place of whatever followed.
void put_textures(const TextureSet& set, std::size_t own_textures, formats::Bsp& io_bsp);

}  // namespace temblor::compiler
