// Builds one surface block: texture, with marks on it, times light.
//
// Light is computed at the samples of the light map (16 texels apart at mip 0) for all styles together.
// (Light maps of other resolutions are resampled at points 1 to 16 texels apart first: light_samples.h.) It
// is interpolated down the sample columns first and then along each row. Numbers per sample, where `sum` is
// that of LightSums (256: the light as stored):
//
//   indexed: t = max(64, (65280 - sum) >> 2); colormap row = t >> 8, stock Quake's arithmetic
//   rgb:     h = min(sum, 65280) >> 1, so that 16384 shows a color as it is;
//            channel = min(255, (2 * color * h + 16384) >> 15), for red, green, and blue
//
// Caustics multiply the sums, at samples that are closer together (caustics.h).
//
// If samples or lights are colored, `sum` of an indexed block is that of the brightest channel. In the light
// of colored dynamic lights, a second table then gives the lit texel the color of the strongest of them
// (tint_tables.h). Its row is interpolated like light: row 31 where all light has that color.
//
// Between samples a and b, i of n texels along (n = 16 >> mip, or fewer):
//   a + (((b - a) * i * (2048 * 16 / n) + 16384) >> 15)
//
// Full-bright palette entries keep their color. Clear texels of alpha-tested textures stay clear: 255 in
// indexed blocks, and 0 in rgb blocks, in which all other texels have alpha 255.
//
// Method: Michael Abrash, "Quake's Lighting Model: Surface Caching" (Graphics Programming Black Book, chapter
// 68).
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/surfaces/light/face_lights.h"
#include "render/surfaces/paint_marks.h"
#include "render/surfaces/surface_block.h"
#include "render/surfaces/surface_cache.h"

namespace temblor::render {

// Everything that determines a block's texels, and where they go.
struct BlockRequest {
  world::FaceIndex face;
  std::uint16_t tile_s, tile_t;
  int mip;
  BlockContents contents;
  std::span<const FaceLight> lights;  // contents.lights is their hash
  std::span<const Mark> marks;        // contents.marks is their revision
  SurfaceBlock block;                 // set when memory is reserved; build_surface writes its texels
  // Replaces the level's texture of the same index (CutoutTextures). Null: the level's.
  const world::Texture* texture = nullptr;
  std::uint32_t draw = 0;  // the number of the SurfaceDraw that needs the block
};

// The size of a tile's block at a mip level; at least 1 x 1.
SurfaceShape surface_shape(const world::Face& face, int tile_s, int tile_t, int mip);

// Writes the texels of request.block. `mark_tables` may be null for requests without marks. `scratch` is
// reset.
void build_surface(const world::Level& level, const ColorTables& tables, const MarkTables* mark_tables,
                   const BlockRequest& request, PixelFormat format, bool simd_kernels, base::Arena& scratch);

}  // namespace temblor::render
