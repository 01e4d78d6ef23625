// The surfaces that cover one place on a row, nearest first.
//
// A set of bits, one for each sort key in use: the lowest bit set is the nearest. Where several surfaces have
// one key (pieces of brush models in one leaf) a list of those in the stack hangs at its bit, and depths
// decide their order.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/edges/active_edges.h"
#include "render/edges/edge_table.h"

namespace temblor::render {

// The order of keys in use; the nearest has rank 0.
struct SurfaceRanks {
  struct Rank {
    std::uint64_t bit;  // 1 << rank % 64
    std::uint32_t rank;
    bool is_shared;  // other surfaces have the same
  };
  std::span<const Rank> of;             // by SurfaceIndex
  std::span<const SurfaceIndex> whose;  // by rank; one of them when it is shared
};
SurfaceRanks rank_surfaces(std::span<const ScreenSurface> surfaces, base::Arena& arena);

class SurfaceStack {
 public:
  // From the edge in `place` on, another surface is in front, or the same one anew.
  struct Switch {
    std::uint32_t place;
    std::uint32_t item;  // the surface's first
  };

  SurfaceStack(const EdgeTable& table, const SurfaceRanks& ranks, base::Arena& arena);

  // Passes all edges of a row, given by their places from the left, beginning with the background alone. A
  // surface is in the stack while more of its leading edges were passed than of its trailing ones.
  void walk(int row, std::span<const double> x, std::span<const EdgeMarks> marks,
            base::ArenaVector<Switch>& out_switches);

  // Whether the depths that the last walk compared compare alike on another row, which the same edges cross
  // in the same order.
  bool comparisons_hold(int row, std::span<const double> x) const;

 private:
  struct Passed {
    std::int32_t row;     // that the rest is about
    std::int32_t inside;  // leading edges, less trailing ones
  };
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
  std::span<SurfaceIndex> next_;  // by surface: the one behind it of the same rank, or kBackground
  base::ArenaVector<Comparison> comparisons_;
};

}  // namespace temblor::render
