#include "lab/world_light/rebuilt_surfaces.h"

#include <algorithm>
#include <functional>

#include "base/arena.h"
#include "lab/world_light/rebuilt_blocks.h"

namespace temblor::lab {

namespace {

using render::BlockRequest;

bool is_at_lower_address(const BlockRequest& a, const BlockRequest& b) {
  return std::less<>()(a.block.texels, b.block.texels);
}

}  // namespace

render::SurfaceBlocks add_rebuilt_blocks(const render::FrameContext& context,
                                         const render::SurfaceRequests& requests,
                                         const render::SurfaceBlocks& blocks, std::uint32_t turn,
                                         std::uint32_t every) {
  base::ArenaVector<BlockRequest> to_build(context.arena(), requests.blocks.size());
  for (BlockRequest request : requests.blocks) {
    if ((base::to_size(request.face) + turn) % every != 0) continue;
    request.block = requests.draws[request.draw].block;
    to_build.push_back(request);
  }
  for (const BlockRequest& request : blocks.missing) to_build.push_back(request);
  const std::span<BlockRequest> all = to_build.view();
  std::ranges::sort(all, is_at_lower_address);
  const auto same_block = [](const BlockRequest& a, const BlockRequest& b) {
    return a.block.texels == b.block.texels;
  };
  const auto end = std::unique(all.begin(), all.end(), same_block);
  render::SurfaceBlocks rebuilt = blocks;
  rebuilt.missing = {all.begin(), end};
  rebuilt.counts.texels_built = 0;
  for (const BlockRequest& request : rebuilt.missing)
    rebuilt.counts.texels_built += request.block.shape.texels();
  return rebuilt;
}

render::FrameStages make_rebuilt_surfaces(std::span<const double> values, Counter* /*counter*/) {
  const auto every = static_cast<std::uint32_t>(values[0]);
  render::FrameStages stages;
  stages.reserve_surfaces = [every, turn = std::uint32_t{0}](const render::FrameContext& context,
                                                             const render::SurfaceRequests& requests,
                                                             render::SurfaceCache& io_cache) mutable {
    const render::SurfaceBlocks blocks = render::reserve_surfaces(context, requests, io_cache);
    return add_rebuilt_blocks(context, requests, blocks, ++turn, every);
  };
  return stages;
}

}  // namespace temblor::lab
