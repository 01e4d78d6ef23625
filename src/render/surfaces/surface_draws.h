// Stage 5. SpanTable -> SurfaceDraws: for every surface that got a span, what its pixels are made from.
// All blocks are requested and reserved before any is built, so nothing that this frame needs is evicted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/edges/span_table.h"
#include "render/frame.h"
#include "render/renderer.h"
#include "render/surfaces/build_surface.h"
#include "render/surfaces/cutout_textures.h"
#include "render/surfaces/surface_cache.h"

namespace temblor::render {

enum class ItemKind : std::uint8_t { kUnused, kNothing, kSurface, kTexture, kLiquid, kSky };

struct SurfaceDraw {
  ItemKind kind = ItemKind::kUnused;
  std::uint8_t mip = 0;
  std::uint8_t light_row = 0;  // kTexture: of the colormap
  SurfaceIndex surface{};
  ScreenPlane depth;
  // Texture coordinates, over z in perspective. kSurface: texels of the block, from its first one. Others:
  // texels of `texture` at `mip`.
  ScreenPlane s, t;
  SurfaceBlock block;                       // kSurface
  const world::Texture* texture = nullptr;  // others
  world::TextureIndex texture_index{};
};

struct SurfaceDraws {
  std::span<const SurfaceDraw> items;  // by item number
  std::uint32_t first_late;            // from here on items are drawn after all others, one surface at a time
};

// `mark_look` is needed for scenes with marks only. `io_job_arenas` grows as needed: one for each job that
// runs at the same time as others.
SurfaceDraws prepare_surfaces(const Scene& scene, const Settings& settings, const ViewFrame& view,
                              const EdgeTable& table, const SpanTable& spans, const ColorTables& color_tables,
                              const CutoutTextures& cutouts, const MarkLook* mark_look, PixelFormat format,
                              base::Jobs& jobs, base::Arena& arena, std::vector<base::Arena>& io_job_arenas,
                              SurfaceCache& io_cache, FrameStats& io_stats);

}  // namespace temblor::render
