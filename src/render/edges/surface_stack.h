// The surface stack: the surfaces that cover the current position on a row, nearest first.
//
// It is a set of bits, one for each sort key in use, and the lowest set bit is the nearest surface. (Stock
// Quake keeps a sorted linked list and searches it for each edge.) Several surfaces have the same key if they
// are fragments of brush models in one leaf: those in the stack form a list at their bit, ordered by 1/z.
//
// Method: Michael Abrash, "Sorted Spans in Action" (Graphics Programming Black Book, chapter 67).
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/active_edges.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

// The sort keys in use, replaced by consecutive ranks; the nearest has rank 0 and the background the highest.
struct SurfaceRanks {
  struct Rank {
    std::uint64_t bit;  // 1 << rank % 64
    std::uint32_t rank;
    bool is_shared;  // other surfaces have the same rank
  };
  std::span<const Rank> by_surface;        // by SurfaceIndex
  std::span<const SurfaceIndex> surfaces;  // by rank; one of them when it is shared
};
SurfaceRanks rank_surfaces(std::span<const ScreenSurface> surfaces, base::Arena& arena);

class SurfaceStack {
 public:
  // A change of the front surface: from the edge at `place` on, another surface is in front, or the same one
  // again after it was left.
  struct Switch {
    std::uint32_t place;
    // The first draw of the surface.
    std::uint32_t draw;
  };

  SurfaceStack(const EdgeTable& table, const SurfaceRanks& ranks, base::Arena& arena);

  // Passes all edges of a row from left to right, beginning with only the background in the stack. A surface
  // is in the stack while more of its leading edges than of its trailing edges were passed; like the counter
  // in Abrash's article, this tolerates edges that rounding has swapped.
  void walk(int row, std::span<const double> x, std::span<const EdgeRecord> records,
            base::ArenaVector<Switch>& out_switches);

  // Whether every depth comparison of the last walk has the same result on another row that is crossed by the
  // same edges in the same order. If so, that row has the same switches.
  bool comparisons_hold(int row, std::span<const double> x) const;

 private:
  // Per-surface state, reset lazily: it is valid only for `row`.
  struct Passed {
    std::int32_t row;
    std::int32_t inside;  // leading edges passed minus trailing edges passed
  };
  // A depth comparison that the last walk made, at the edge where surface `begun` began.
  struct Comparison {
    std::uint32_t place;
    SurfaceIndex begun, other;
    bool begun_is_nearer;
  };

  bool leave_shared(SurfaceIndex surface);
  bool begin_shared(SurfaceIndex surface, int row, std::uint32_t place, double x);
  bool is_nearer(SurfaceIndex begun, SurfaceIndex other, double x, int row) const;

  const EdgeTable& table_;
  std::span<const SurfaceRanks::Rank> ranks_;  // by surface
  std::span<Passed> passed_;                   // by surface
  std::span<std::uint64_t> covering_;          // a bit by rank
  std::span<SurfaceIndex> first_;              // by rank: the nearest of its surfaces in the stack
  // By surface: the next one behind it with the same rank, or kBackground.
  std::span<SurfaceIndex> next_;
  base::ArenaVector<Comparison> comparisons_;
};

}  // namespace temblor::render
