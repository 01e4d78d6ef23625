#include "render/sprites/draw_sprites.h"

#include <algorithm>

#include "render/sprites/sprite_rows.h"

namespace temblor::render {

namespace {

void draw_sprite(const SpriteQuad& quad, const ColorTables& tables, bool simd_kernels, RowRange rows,
                 FrameBuffer& io_frame) {
  const int end = std::min(quad.end_row, rows.end);
  for (int y = std::max(quad.first_row, rows.first); y < end; ++y) {
    std::optional<PlacedSpriteRow> placed = place_sprite_row(quad, tables, y, io_frame.width());
    if (!placed) continue;
    const auto draw = [&](auto* io_pixels) {
      placed->row.frame_depth = io_frame.depth().data() + placed->first_pixel;
      placed->row.pixels = io_pixels;
      draw_sprite_row(placed->row, io_pixels, simd_kernels);
    };
    if (io_frame.format() == PixelFormat::kIndexed)
      draw(io_frame.indexed().data() + placed->first_pixel);
    else
      draw(io_frame.rgb().data() + placed->first_pixel);
  }
}

}  // namespace

std::span<const SpriteQuad> place_sprites(const Scene& scene, const ViewFrame& view, base::Arena& arena) {
  base::ArenaVector<SpriteQuad> quads(arena, scene.sprites.size());
  for (const SpriteInstance& sprite : scene.sprites) {
    if (sprite.alpha < 1) continue;
    if (const std::optional<SpriteQuad> quad = make_sprite_quad(view, sprite)) quads.push_back(*quad);
  }
  return quads.view();
}

void draw_sprites(std::span<const SpriteQuad> quads, const ColorTables& tables, bool simd_kernels,
                  RowRange rows, FrameBuffer& io_frame) {
  for (const SpriteQuad& quad : quads) draw_sprite(quad, tables, simd_kernels, rows, io_frame);
}

}  // namespace temblor::render
