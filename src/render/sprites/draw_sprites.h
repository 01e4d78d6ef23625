// Stage 7, second part: sprites, flat unlit pictures in the world, tested against depth.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/color/color_tables.h"
#include "render/color/fog.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/sprites/sprite_quad.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// How a sprite's texels are combined with the frame. The default is opaque.
struct SpriteBlend {
  const std::uint8_t* table = nullptr;  // indexed: [over * 256 + under] is the index to write; null: opaque
  int opacity_256 = 256;                // rgb: 0 to 256
  const FrameFog* fog = nullptr;        // null for opaque sprites, which are fogged with the whole picture
  bool is_opaque(PixelFormat format) const {
    return format == PixelFormat::kIndexed ? table == nullptr : opacity_256 >= 256;
  }
};

// Draws the part of a quad in `rows`, which must be inside the frame. A pixel whose center the quad covers is
// drawn if the quad is at least as near as what is there and the texel is not 255. Opaque sprites also write
// depth.
void draw_sprite_instance(const SpriteQuad& quad, const SpriteBlend& blend, const ColorTables& tables,
                          bool simd_kernels, RowRange rows, FrameBuffer& io_frame);

// All visible sprites with alpha 1, in the scene's order. Lives in `arena`.
std::span<const SpriteQuad> place_sprites(const Scene& scene, const ViewFrame& view, base::Arena& arena);

// Draws the part of the quads in `rows`. Requires the depth of everything that is drawn before.
void draw_sprites(std::span<const SpriteQuad> quads, const ColorTables& tables, bool simd_kernels,
                  RowRange rows, FrameBuffer& io_frame);

}  // namespace temblor::render
