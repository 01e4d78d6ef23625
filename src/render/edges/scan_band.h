// The scan of one band: active edges and the surface stack. See span_table.h.
#pragma once

#include "base/arena.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

struct ScannedSpan {
  SurfaceIndex surface;
  std::uint16_t x, y, count;
};

// Appends the spans of rows [first_row, first_row + row_count), each row's from left to right.
void scan_band(const EdgeTable& table, int first_row, int row_count, int width, base::Arena& arena,
               base::ArenaVector<ScannedSpan>& io_spans);

}  // namespace temblor::render
