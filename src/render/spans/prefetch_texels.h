// Texels are asked for before they are drawn from. The spans of a slanted face walk across the rows of its
// surface, and the processor foresees such walks badly: waiting for one cache line after another takes longer
// than drawing. Here a band's whole share of a surface is asked for at once, row by row.
#pragma once

#include <span>

#include "render/edges/span_run.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// For an item of kind kSurface, and its runs in one band. A hint: draws nothing, changes nothing.
void prefetch_texels(const SurfaceDraw& item, std::span<const SpanRun> runs, bool perspective,
                     std::size_t bytes_per_texel);

}  // namespace temblor::render
