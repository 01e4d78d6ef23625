// The rows of a sprite, ready for the row kernels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "render/color/color_tables.h"
#include "render/sprites/sprite_kernels.h"
#include "render/sprites/sprite_quad.h"

namespace temblor::render {

// `row` has no destination yet.
struct PlacedSpriteRow {
  SpriteRow row;
  std::size_t first_pixel;  // its number in the frame
};

// The pixels of row `y` whose centers the quad covers; nothing if there are none in a frame of this width.
std::optional<PlacedSpriteRow> place_sprite_row(const SpriteQuad& quad, const ColorTables& tables, int y,
                                                int frame_width);

// Draw the row with the kernel for the pixels' format.
void draw_sprite_row(const SpriteRow& row, const std::uint8_t* pixels, bool simd_kernels);
void draw_sprite_row(const SpriteRow& row, const std::uint32_t* pixels, bool simd_kernels);

}  // namespace temblor::render
