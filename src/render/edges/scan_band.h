// The scan of one band: active edges and the surface stack. See span_table.h.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/edges/edge_table.h"
#include "render/edges/span_run.h"
#include "render/edges/surface_stack.h"

namespace temblor::render {

struct ItemSpan {
  std::uint32_t item;
  SpanRun run;
};

// The spans of rows [first_row, first_row + row_count), each row's from left to right, not yet cut at tiles:
// all are of their surfaces' first items. They live on the arena.
std::span<const ItemSpan> scan_band(const EdgeTable& table, const SurfaceRanks& ranks, int first_row,
                                    int row_count, int width, base::Arena& arena);

}  // namespace temblor::render
