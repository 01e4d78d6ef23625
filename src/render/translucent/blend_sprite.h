// Blends a translucent sprite with the picture behind it.
#pragma once

#include <cstdint>

#include "render/color/color_tables.h"
#include "render/color/fog.h"
#include "render/frame_buffer.h"
#include "render/sprites/sprite_quad.h"
#include "render/view/view_frame.h"

namespace temblor::render {

struct SpriteBlend {
  const std::uint8_t* table = nullptr;  // indexed: [over * 256 + under] is the index to write
  int opacity_256 = 256;                // rgb: 0 to 256
  const FrameFog* fog = nullptr;        // null: no fog
};

// Draws the part of a quad in `rows`, which must be inside the frame. A pixel whose center the quad covers is
// fogged and blended if the quad is at least as near as what is there and the texel is not 255. Depth does
// not change.
void blend_sprite(const SpriteQuad& quad, const SpriteBlend& blend, const ColorTables& tables,
                  bool simd_kernels, RowRange rows, FrameBuffer& io_frame);

}  // namespace temblor::render
