// Blocks that are built although the cache has them.
#pragma once

#include <cstdint>

#include "render/surfaces/surface_draws.h"

namespace temblor::lab {

// `blocks`, the result of render::reserve_surfaces, with more missing ones: one of `every` of the requested
// blocks, by the number of their face plus `turn`. A block that several draws share is missing only once.
render::SurfaceBlocks add_rebuilt_blocks(const render::FrameContext& context,
                                         const render::SurfaceRequests& requests,
                                         const render::SurfaceBlocks& blocks, std::uint32_t turn,
                                         std::uint32_t every);

}  // namespace temblor::lab
