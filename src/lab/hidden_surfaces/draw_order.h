// Surfaces from the farthest to the nearest, and bands whose draws are in a given order. The engine's order
// of draws within a band does not matter, because its spans do not overlap.
#pragma once

#include <cstdint>
#include <span>

#include "lab/hidden_surfaces/surface_edges.h"
#include "render/edges/span_table.h"

namespace temblor::lab {

// Opaque surfaces by sort key, the background first. Fragments of brush models with equal keys are
// compared by their planes.
// Lives in the frame's arena.
std::span<const std::uint32_t> order_back_to_front(const render::FrameContext& context,
                                                   const render::EdgeTable& table, const SurfaceEdges& edges,
                                                   int width);

// Returns the bands with their opaque draws in the order of `surfaces`, so that later ones are drawn over
// earlier ones.
render::SpanTable order_draws(const render::FrameContext& context, const render::EdgeTable& table,
                              const render::SpanTable& spans, std::span<const std::uint32_t> surfaces);

}  // namespace temblor::lab
