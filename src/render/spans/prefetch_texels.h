// Prefetches texels before spans are drawn. The spans of a slanted face cross the rows of its block at an
// angle, a pattern that hardware prefetchers predict badly, and waiting for one cache line after another
// takes longer than drawing. So a band's whole share of a block is requested at once, row by row.
#pragma once

#include <span>

#include "render/edges/span.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// For a draw of kind kBlock and its spans in one band. A hint to the processor: changes no results.
void prefetch_texels(const SurfaceDraw& draw, std::span<const Span> spans, bool perspective,
                     std::size_t bytes_per_texel);

}  // namespace temblor::render
