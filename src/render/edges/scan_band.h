// The scan of one band, with the active edges and the surface stack. See span_table.h.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"
#include "render/edges/span.h"
#include "render/edges/surface_stack.h"

namespace temblor::render {

// A span before spans are grouped by draw.
struct DrawSpan {
  std::uint32_t draw;
  Span span;
};

// The spans of `rows`, each row's from left to right. They are not split at tiles yet: all have the first
// draw of their surface. They live in `arena`.
std::span<const DrawSpan> scan_band(const EdgeTable& table, const SurfaceRanks& ranks, RowRange rows,
                                    int width, base::Arena& arena);

}  // namespace temblor::render
