// Stage 4. EdgeTable -> SpanTable: scans the edges row by row. Every pixel belongs to the spans of exactly
// one opaque surface, so the world is drawn without overdraw; spans of deferred faces are added to that.
//
//   row y    |--- A ---|------ B ------|-- A --|          edges from left to right,
//            0         ^               ^       width      spans between the changes of the front surface
//
// Bands of rows are scanned in parallel, because an edge's position in any row can be computed directly.
//
// Method: Michael Abrash, "Sorted Spans in Action" (Graphics Programming Black Book, chapter 67).
#pragma once

#include <cstdint>
#include <span>

#include "render/edges/edge_table.h"
#include "render/edges/span.h"

namespace temblor::render {

// Sums over the pixels of one draw's spans: their number and coordinates. x / pixels and y / pixels are the
// center of the visible part.
struct PixelSum {
  std::uint64_t pixels = 0, x = 0, y = 0;
};

// A band of scan lines and its spans, grouped by draw (one surface, or one tile of a large surface):
//
//   draws       2         7         9           draw numbers; those of deferred faces come last
//   span_begin  0         3         4      6    where each draw's spans begin; one more at the end
//   spans       a  b  c   d         e  f        each group ordered by row, then from left to right
//
// The spans of opaque surfaces cover each pixel once; those of some techniques of the laboratory overlap, and
// later draws are in front. A deferred surface's spans cover everything that it would cover if it were alone
// on the screen.
struct Band {
  int first_row, row_count;
  std::span<const Span> spans;
  std::span<const std::uint32_t> draws;
  std::span<const std::uint32_t> span_begin;
  std::span<const PixelSum> sums;  // by position in `draws`

  // The spans of draw number draws[position].
  std::span<const Span> spans_at(std::size_t position) const {
    return spans.subspan(span_begin[position], span_begin[position + 1] - span_begin[position]);
  }
};

struct SpanTable {
  std::span<const Band> bands;
};

// Runs one job per band. Bands and spans live in FrameArenas::bands and the frame's arena.
SpanTable scan_edges(const FrameContext& context, const ViewFrame& view, const EdgeTable& table);

}  // namespace temblor::render
