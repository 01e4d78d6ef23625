// Stage 4. EdgeTable -> SpanTable: every pixel of the screen given to exactly one surface, and to late ones
// beside it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/edges/edge_table.h"
#include "render/edges/span_run.h"

namespace temblor::render {

// Sums over the pixels of one item's runs: where on the screen it is seen, and how large.
struct PixelSum {
  std::uint64_t pixels = 0, x = 0, y = 0;
};

// A band of scan lines, and the spans in it grouped by item: one surface, or one tile of a large one. Those
// of all but late surfaces cover each pixel once; those of a late one cover what it would if it were alone.
struct Band {
  int first_row, row_count;
  std::span<const SpanRun> runs;
  std::span<const std::uint32_t> items;      // that have runs here, increasing
  std::span<const std::uint32_t> run_begin;  // by position in `items`, and one more at the end
  std::span<const PixelSum> sums;            // by position in `items`

  std::span<const SpanRun> runs_at(std::size_t position) const {
    return runs.subspan(run_begin[position], run_begin[position + 1] - run_begin[position]);
  }
};

struct SpanTable {
  std::span<const Band> bands;
};

// Each band's memory comes from its own arena: one job a band. `io_band_arenas` grows as needed.
SpanTable scan_edges(const EdgeTable& table, const Scene& scene, const ViewFrame& view, int band_rows,
                     base::Jobs& jobs, base::Arena& arena, std::vector<base::Arena>& io_band_arenas);

}  // namespace temblor::render
