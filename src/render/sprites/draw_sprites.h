// Stage 7, second part: opaque sprites, flat unlit pictures in the world, tested against depth.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/sprites/sprite_quad.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// All visible sprites with alpha 1, in the scene's order. Lives in `arena`.
std::span<const SpriteQuad> place_sprites(const Scene& scene, const ViewFrame& view, base::Arena& arena);

// Draws the part of the quads in `rows`, which must be inside the frame. Requires the depth of everything
// that is drawn before. A pixel whose center a quad covers is drawn, with its depth, if the quad is at least
// as near as what is there and the texel is not 255.
void draw_sprites(std::span<const SpriteQuad> quads, const ColorTables& tables, bool simd_kernels,
                  RowRange rows, FrameBuffer& io_frame);

}  // namespace temblor::render
