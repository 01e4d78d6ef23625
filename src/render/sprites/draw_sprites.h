// Sprites: flat pictures in the world, tested against depth pixel by pixel, unlit.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/color/color_tables.h"
#include "render/color/fog.h"
#include "render/frame.h"
#include "render/scene.h"
#include "render/sprites/sprite_quad.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// How texels join what is there.
struct SpriteBlend {
  const std::uint8_t* table = nullptr;  // indexed: [over * 256 + under] is the index to write; null: opaque
  int opacity_256 = 256;                // rgb: 0 to 256
  const FrameFog* fog = nullptr;        // that lies before it; opaque ones are fogged with the picture
  bool is_opaque(PixelFormat format) const {
    return format == PixelFormat::kIndexed ? table == nullptr : opacity_256 >= 256;
  }
};

// Draws the rows of a quad that lie in `rows`, which lie in the frame. Pixels whose centers the quad covers
// change where it is as near as what is there or nearer, and the texel is not 255. Opaque ones leave their
// depth.
void draw_sprite_instance(const SpriteQuad& quad, const SpriteBlend& blend, const ColorTables& tables,
                          bool vector_kernels, RowRange rows, FrameBuffer& io_frame);

// All sprites in view whose alpha is 1, in order; in the arena.
std::span<const SpriteQuad> place_sprites(const Scene& scene, const ViewFrame& view, base::Arena& arena);

// Draws their part of `rows`. Needs the depth of everything that is drawn before.
void draw_sprites(std::span<const SpriteQuad> quads, const ColorTables& tables, bool vector_kernels,
                  RowRange rows, FrameBuffer& io_frame);

}  // namespace temblor::render
