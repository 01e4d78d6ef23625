// 1/z of every opaque surface, for techniques that compare depths. (The engine compares sort keys, and
// computes the depth planes of visible surfaces only.)
#pragma once

#include <span>

#include "render/edges/edge_table.h"

namespace temblor::lab {

// ViewFrame::depth on the plane of each surface, by SurfaceIndex. The background's is infinitely far away.
// Lives in the frame's arena.
std::span<const render::ScreenPlane> find_surface_depths(const render::FrameContext& context,
                                                         const render::ViewFrame& view,
                                                         const render::EdgeTable& table);

}  // namespace temblor::lab
