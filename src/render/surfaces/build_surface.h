// One block: texture, with marks on it, x light. Abrash, "Surface Caching".
//
// Light is worked out at the light map's samples (one every 16 texels), all styles summed, then interpolated:
// down the sample columns first, then along each row. Numbers per sample:
//   indexed: t = (65280 - sum) >> 2, at least 64; colormap row = t >> 8 (the original's arithmetic)
//   rgb, for red, green, blue: h = min(sum, 65280) >> 1, so that 16384 shows a color as it is, and
//        channel = min(255, (2 * color * h + 16384) >> 15)
// where sum is LightSums' (256: a light of 1). Between two samples a
// and b, i of n texels along: a + (((b - a) * i * (2048 * 16 / n) + 16384) >> 15), n = 16 >> mip.
// Full-bright palette entries keep their color. Clear texels of textures with holes stay clear: 255 in
// indexed, 0 in rgb, where all others have an alpha of 255.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/color/color_tables.h"
#include "render/frame.h"
#include "render/surfaces/face_lights.h"
#include "render/surfaces/paint_marks.h"
#include "render/surfaces/surface_block.h"
#include "render/surfaces/surface_cache.h"

namespace temblor::render {

struct BlockRequest {
  world::FaceIndex face;
  std::uint16_t tile_s, tile_t;
  int mip;
  BlockContents contents;
  std::span<const FaceLight> lights;  // those that contents.lights is the hash of
  std::span<const Mark> marks;        // those of contents.marks
  SurfaceBlock block;
  const world::Texture* texture = nullptr;  // drawn in place of the level's own; null: that
};

SurfaceShape surface_shape(const world::Face& face, int tile_s, int tile_t, int mip);

// `mark_look` is needed for requests with marks only.
void build_surface(const world::Level& level, const ColorTables& tables, const MarkLook* mark_look,
                   const BlockRequest& request, PixelFormat format, bool vector_kernels,
                   base::Arena& scratch);

}  // namespace temblor::render
