// Finds the leaves that the eye sees through portals.
//
//   1. The eye's leaf is seen through the whole screen.
//   2. Each portal of a leaf is projected. The part of the leaf's window that it covers is the window of the
//      leaf behind it, which continues from there.
//   3. A leaf that is seen through several chains of portals has one window around all of theirs. It is
//      visited again when its window grows.
//
// Windows are whole pixels and never too small, so no leaf is missing that a pixel shows.
//
// Method: Seth Teller and Carlo Sequin, "Visibility Preprocessing for Interactive Walkthroughs" (1991), for
// portals; David Luebke and Chris Georges, "Portals and Mirrors: Simple, Fast Evaluation of Potentially
// Visible Sets" (1995), for windows on the screen.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "lab/visible_faces/leaf_portals.h"
#include "render/view/view_frame.h"

namespace temblor::lab {

struct FloodRules {
  bool uses_octagons = false;                 // false: rectangles
  std::span<const std::uint8_t> enterable{};  // one bit for each leaf, as in find_leaves_in_pvs; empty: all
};

struct FloodResult {
  std::span<const std::uint8_t> leaves;  // one bit for each leaf, as in find_leaves_in_pvs
  std::uint64_t portals_clipped = 0, leaves_reached = 0;
};

// Requires a perspective view from an open leaf (not leaf 0), within the extent of the portals. A leaf is
// visited at most kMaxLeafVisits times, and then seen through the whole screen. The result lives in `arena`.
constexpr int kMaxLeafVisits = 8;
FloodResult flood_portals(const LevelPortals& level, const render::ViewFrame& view, const FloodRules& rules,
                          base::Arena& arena);

}  // namespace temblor::lab
