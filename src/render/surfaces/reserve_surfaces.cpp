#include <algorithm>

#include "render/surfaces/surface_draws.h"

namespace temblor::render {

namespace {

std::size_t find_slot(const SurfaceCache& cache, const BlockRequest& request, const world::Level& level) {
  const TileGrid grid = tile_grid(level.face(request.face));
  return cache.slot(request.face, std::size_t{request.tile_t} * grid.s + request.tile_s, request.mip);
}

// The fragments of a brush model's face share one block, which counts once.
void count_use(const SurfaceCache::Lookup& lookup, SurfaceCounts& io_counts) {
  if (!lookup.first_use) return;
  ++io_counts.surfaces;
  io_counts.texels += lookup.block.shape.texels();
}

}  // namespace

void begin_surface_frame(const FrameContext& context, SurfaceCache& io_cache) {
  const Settings& settings = context.settings;
  io_cache.begin_frame(context.level(), context.is_indexed() ? 1 : 4, settings.cache_bytes,
                       settings.surface_cache);
}

// Two passes: the first marks the blocks that are in the cache as used, so that reserving memory for the
// others in the second pass cannot evict them.
SurfaceBlocks reserve_surfaces(const FrameContext& context, const SurfaceRequests& requests,
                               SurfaceCache& io_cache) {
  const world::Level& level = context.level();
  base::ArenaVector<BlockRequest> missing(context.arena(), 256);
  base::ArenaVector<std::uint32_t> not_found(context.arena(), 256);  // into requests.blocks
  SurfaceCounts counts;
  for (std::uint32_t i = 0; i < requests.blocks.size(); ++i) {
    const BlockRequest& request = requests.blocks[i];
    SurfaceCache::Lookup found;
    if (!io_cache.find(find_slot(io_cache, request, level), request.contents, found)) {
      not_found.push_back(i);
      continue;
    }
    requests.draws[request.draw].block = found.block;
    count_use(found, counts);
  }
  for (const std::uint32_t i : not_found) {
    BlockRequest& request = requests.blocks[i];
    const SurfaceShape shape =
        surface_shape(level.face(request.face), request.tile_s, request.tile_t, request.mip);
    const SurfaceCache::Lookup reserved =
        io_cache.reserve(find_slot(io_cache, request, level), request.contents, shape);
    requests.draws[request.draw].block = request.block = reserved.block;
    count_use(reserved, counts);
    if (!reserved.must_build) continue;
    missing.push_back(request);
    counts.texels_built += shape.texels();
  }
  counts.cache = io_cache.counts();
  counts.cache_bytes = io_cache.bytes_in_use();
  return {{requests.draws, requests.first_deferred}, missing.view(), counts};
}

// Interleaved: neighboring requests are often of similar size, so every job gets a mix.
void build_surfaces(const FrameContext& context, const SurfaceBlocks& blocks, const MarkTables* mark_tables) {
  constexpr std::size_t kJobsPerThread = 8;
  const std::size_t job_count = std::min<std::size_t>(
      blocks.missing.size(), static_cast<std::size_t>(context.jobs.threads()) * kJobsPerThread);
  std::vector<base::Arena>& scratch = context.arenas.scratch;
  FrameArenas::grow(scratch, job_count);
  context.jobs.parallel_for(job_count, [&](std::size_t job) {
    for (std::size_t i = job; i < blocks.missing.size(); i += job_count)
      build_surface(context.level(), context.colors, mark_tables, blocks.missing[i], context.format,
                    context.settings.simd_kernels, scratch[job]);
  });
}

}  // namespace temblor::render
