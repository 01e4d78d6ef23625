// Connects the texture names on sides of brushes with the textures in a level.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "compiler/report.h"
#include "compiler/texture_set.h"
#include "formats/levels/bsp.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// The names on all sides that are drawn, in order; some repeat.
std::vector<std::string_view> find_texture_names(const formats::Map& map);

// Warns about each texture that no source has: the number of its faces, and where the first one is.
void warn_about_missing_textures(const formats::Map& map, const TextureSet& set, std::size_t source_count,
                                 Warnings& io_warnings);

// A texture's width and height in texels; 64 x 64 if the set does not have it.
math::Vec2d find_texture_size(const TextureSet& set, std::string_view name);

// Replaces the level's first `own_textures`, which are known by name, by those of the set, and all later ones
// by the other frames of their animations.
void set_textures(const TextureSet& set, std::size_t own_textures, formats::Bsp& io_bsp);

}  // namespace temblor::compiler
