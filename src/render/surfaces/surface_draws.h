// Stage 5. SpanTable -> SurfaceDraws: decides how each surface that has spans gets its pixels, and builds the
// surface blocks that are missing from the cache. Three steps, so that blocks that this frame needs are never
// evicted by this frame:
//
//   select_surfaces   which surfaces have spans; planes, mip level, light       -> SurfaceRequests
//   reserve_surfaces  finds or reserves a block in the cache for each request   -> SurfaceBlocks
//   build_surfaces    fills the reserved blocks: texture x light (build_surface.h)
//
// After that, drawing only reads. Only visible surfaces are built, because the edge scan has no overdraw.
//
// Method: Michael Abrash, "Quake's Lighting Model: Surface Caching" (Graphics Programming Black Book, chapter
// 68).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/edges/span_table.h"
#include "render/surfaces/build_surface.h"
#include "render/surfaces/cutout_textures.h"
#include "render/surfaces/light/caustics.h"
#include "render/surfaces/surface_cache.h"
#include "render/view/frame_context.h"

namespace temblor::render {

// The source of the pixels of a surface's spans.
enum class SurfaceKind : std::uint8_t {
  kHidden,   // has no spans
  kNothing,  // the background: palette entry 0
  kBlock,    // a surface block
  kTexture,  // the texture itself, repeated: faces without light
  kLiquid,   // the texture itself, warped by sines
  kSky       // two scrolling layers, or the skybox
};

// How the spans of one tile of a surface are drawn. Most surfaces have one tile, large ones have several.
struct SurfaceDraw {
  SurfaceKind kind = SurfaceKind::kHidden;
  std::int8_t mip = 0;  // Texture::finest_mip() to 3
  // kTexture: the row of the colormap.
  std::uint8_t light_row = 0;
  SurfaceIndex surface{};
  ScreenPlane depth;
  // Texture coordinates, in perspective divided by z. kBlock: in texels of the block, from its first texel.
  // Other kinds: in texels of `texture` at `mip`.
  ScreenPlane s, t;
  SurfaceBlock block;                       // kBlock only
  const world::Texture* texture = nullptr;  // the texture of this frame, after animation
  world::TextureIndex texture_index{};
};

// The draws of a frame.
struct SurfaceDraws {
  // By draw number, as in Band::draws; 0 is the background.
  std::span<const SurfaceDraw> all;
  // Draws from this number on belong to deferred faces, which are drawn later, one face at a time.
  std::uint32_t first_deferred;

  bool has_deferred() const { return first_deferred < all.size(); }
};

// The result of select_surfaces.
struct SurfaceRequests {
  std::span<SurfaceDraw> draws;  // complete except for their blocks
  std::uint32_t first_deferred;
  std::span<BlockRequest> blocks;  // one for each draw of kind kBlock, in the order of the draws
};

// Statistics of the stage; see FrameStats.
struct SurfaceCounts {
  CacheCounts cache;
  std::size_t cache_bytes = 0;  // in use
  std::uint32_t surfaces = 0;   // different blocks
  std::uint64_t texels = 0;     // in those blocks
  std::uint64_t texels_built = 0;
};

// The result of reserve_surfaces.
struct SurfaceBlocks {
  SurfaceDraws draws;                     // complete; missing blocks have memory but no texels yet
  std::span<const BlockRequest> missing;  // the blocks to build
  SurfaceCounts counts;
};

// `cutouts` and `water_faces` must be those of the scene's level. Runs in parallel over surfaces.
SurfaceRequests select_surfaces(const FrameContext& context, const ViewFrame& view, const EdgeTable& table,
                                const SpanTable& spans, const CutoutTextures& cutouts,
                                const WaterFaces& water_faces);

// Begins a frame of the cache. Views that are drawn at once share one.
void begin_surface_frame(const FrameContext& context, SurfaceCache& io_cache);

// Sets the blocks of the requests' draws. Blocks stay in place until the next frame. Runs on one thread,
// since the cache is not thread-safe.
SurfaceBlocks reserve_surfaces(const FrameContext& context, const SurfaceRequests& requests,
                               SurfaceCache& io_cache);

// Builds the missing blocks in parallel. `mark_tables` may be null for scenes without marks.
void build_surfaces(const FrameContext& context, const SurfaceBlocks& blocks, const MarkTables* mark_tables);

}  // namespace temblor::render
