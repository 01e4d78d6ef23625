#include "render/edges/surface_stack.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/check.h"

namespace temblor::render {

// Ranks are dense, so the stack's bits fit a few words. by_rank keeps one surface per rank, which is the only
// one unless the rank is shared.
SurfaceRanks rank_surfaces(std::span<const ScreenSurface> surfaces, base::Arena& arena) {
  struct Keyed {
    SortKey key;
    std::uint32_t surface;
  };
  const std::size_t count = surfaces.size();
  std::span<Keyed> keyed = arena.allocate<Keyed>(count);
  for (std::uint32_t i = 0; i < count; ++i) keyed[i] = {surfaces[i].key, i};
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
  std::span<SurfaceRanks::Rank> ranks = arena.allocate<SurfaceRanks::Rank>(count);
  std::span<SurfaceIndex> by_rank = arena.allocate<SurfaceIndex>(count);
  std::uint32_t rank = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool as_before = i > 0 && keyed[i].key == keyed[i - 1].key;
    const bool as_next = i + 1 < count && keyed[i].key == keyed[i + 1].key;
    if (i > 0 && !as_before) ++rank;
    ranks[keyed[i].surface] = {std::uint64_t{1} << rank % 64, rank, as_before || as_next};
    by_rank[rank] = SurfaceIndex{keyed[i].surface};
  }
  CHECK(ranks[0].rank == rank && !ranks[0].is_shared, "a surface behind the background");
  return {ranks, by_rank.first(rank + 1)};
}

SurfaceStack::SurfaceStack(const EdgeTable& table, const SurfaceRanks& ranks, base::Arena& arena)
    : table_(table),
      ranks_(ranks.by_surface),
      passed_(arena.allocate_filled<Passed>(ranks.by_surface.size(), {-1, 0})),
      covering_(arena.allocate<std::uint64_t>(ranks.surfaces.size() / 64 + 1)),
      first_(arena.allocate<SurfaceIndex>(ranks.surfaces.size())),
      next_(arena.allocate<SurfaceIndex>(ranks.by_surface.size())),
      comparisons_(arena) {
  std::copy(ranks.surfaces.begin(), ranks.surfaces.end(), first_.begin());
}

void SurfaceStack::walk(int row, std::span<const double> x, std::span<const EdgeRecord> records,
                        base::ArenaVector<Switch>& out_switches) {
  comparisons_.clear();
  std::fill(covering_.begin(), covering_.end(), std::uint64_t{0});
  const SurfaceRanks::Rank& background = ranks_[base::to_size(kBackground)];
  covering_[background.rank / 64] = background.bit;

  // Local copies of the pointers, so that the compiler knows that stores do not change them.
  const SurfaceRanks::Rank* const ranks = ranks_.data();
  Passed* const passed = passed_.data();
  std::uint64_t* const covering = covering_.data();
  const SurfaceIndex* const first = first_.data();
  const ScreenSurface* const surfaces = table_.surfaces.data();
  const auto inside = [=](SurfaceIndex surface) -> std::int32_t& {
    Passed& found = passed[base::to_size(surface)];
    if (found.row != row) found = {row, 0};
    return found.inside;
  };
  std::uint32_t front = background.rank;  // the lowest rank in the stack
  out_switches.clear();
  Switch* next_switch = out_switches.extend(records.size());
  for (std::size_t place = 0; place < records.size(); ++place) {
    const SurfaceIndex trailing = records[place].trailing, leading = records[place].leading;
    bool switched = false;
    if (trailing != kBackground && --inside(trailing) == 0) {
      const SurfaceRanks::Rank& left = ranks[base::to_size(trailing)];
      bool was_first = true;
      if (left.is_shared) [[unlikely]]
        was_first = leave_shared(trailing);
      else
        covering[left.rank / 64] ^= left.bit;
      switched = was_first && left.rank == front;
    }
    if (leading != kBackground && ++inside(leading) == 1) {
      const SurfaceRanks::Rank& begun = ranks[base::to_size(leading)];
      bool is_first = true;
      if (begun.is_shared) [[unlikely]]
        is_first = begin_shared(leading, row, static_cast<std::uint32_t>(place), x[place]);
      else
        covering[begun.rank / 64] ^= begun.bit;
      if (is_first && begun.rank <= front) {
        front = begun.rank;
        switched = true;
      }
    }
    if (!switched) continue;
    // The old front was the lowest rank, so the new one is found upward from it; the background always stays.
    std::uint32_t word = front / 64;
    while (covering[word] == 0) ++word;
    front = word * 64 + static_cast<std::uint32_t>(std::countr_zero(covering[word]));
    *next_switch++ = {static_cast<std::uint32_t>(place), surfaces[base::to_size(first[front])].first_draw};
  }
  out_switches.shrink(static_cast<std::size_t>(next_switch - out_switches.data()));
}

// Removes the surface from the list of its rank. Returns whether it was the nearest of its rank.
bool SurfaceStack::leave_shared(SurfaceIndex surface) {
  const SurfaceRanks::Rank& left = ranks_[base::to_size(surface)];
  SurfaceIndex* nearer = &first_[left.rank];
  const bool was_first = *nearer == surface;
  while (*nearer != surface) nearer = &next_[base::to_size(*nearer)];
  *nearer = next_[base::to_size(surface)];
  if (first_[left.rank] == kBackground) covering_[left.rank / 64] ^= left.bit;
  return was_first;
}

// Inserts the surface into the list of its rank, by depth at the edge. Returns whether it is the nearest.
bool SurfaceStack::begin_shared(SurfaceIndex surface, int row, std::uint32_t place, double x) {
  const SurfaceRanks::Rank& begun = ranks_[base::to_size(surface)];
  std::uint64_t& covering = covering_[begun.rank / 64];
  if ((covering & begun.bit) == 0) first_[begun.rank] = kBackground;
  covering |= begun.bit;
  SurfaceIndex* nearer = &first_[begun.rank];
  while (*nearer != kBackground) {
    const bool begun_is_nearer = is_nearer(surface, *nearer, x, row);
    comparisons_.push_back({place, surface, *nearer, begun_is_nearer});
    if (begun_is_nearer) break;
    nearer = &next_[base::to_size(*nearer)];
  }
  next_[base::to_size(surface)] = *nearer;
  *nearer = surface;
  return first_[begun.rank] == surface;
}

bool SurfaceStack::comparisons_hold(int row, std::span<const double> x) const {
  return std::all_of(comparisons_.begin(), comparisons_.end(), [&](const Comparison& comparison) {
    return is_nearer(comparison.begun, comparison.other, x[comparison.place], row) ==
           comparison.begun_is_nearer;
  });
}

// Abrash calls this abutting span sorting. The surface with the larger 1/z is in front. If the two touch at
// the edge, the one whose 1/z grows faster to the right is in front; with equal gradients, the smaller
// number.
bool SurfaceStack::is_nearer(SurfaceIndex begun, SurfaceIndex other, double x, int row) const {
  // Relative. Stock Quake allows one part in a hundred, which treats faces as touching that are well apart.
  constexpr double kTouching = 1e-5;
  const ScreenPlane& plane = table_.fragments[table_.surfaces[base::to_size(begun)].fragment].depth;
  const ScreenPlane& other_plane = table_.fragments[table_.surfaces[base::to_size(other)].fragment].depth;
  const double depth = plane.at(x, row), other_depth = other_plane.at(x, row);
  // Orthographic depths are negative, so the tolerance is relative to the absolute value.
  const double tolerance = kTouching * std::abs(depth);
  if (depth - tolerance >= other_depth) return true;
  if (depth + tolerance < other_depth) return false;
  return plane.dx > other_plane.dx || (plane.dx == other_plane.dx && begun < other);
}

}  // namespace temblor::render
