// Brushes for the clip hulls, grown by the hull's box: tracing a point against the grown brushes is the same
// as tracing the box against the original ones (a Minkowski sum, or configuration-space obstacle).
#pragma once

#include "compiler/bsp/brushes/brush.h"

namespace temblor::compiler {

// A box around the origin of a player or monster, in units.
struct HullBox {
  math::Vec3d mins, maxs;
  std::size_t key_hull;  // the hull of the key "_hulls" that includes it: 1 for players, 2 for large monsters
};
// The boxes of clip hulls 1, 2, ... The sizes are those that the game expects in every level. Half-Life's
// third one is for ducking players.
constexpr std::array<HullBox, 2> kQuakeBoxes = {
    {{{-16, -16, -24}, {16, 16, 32}, 1}, {{-32, -32, -24}, {32, 32, 64}, 2}}};
constexpr std::array<HullBox, 3> kHalfLifeBoxes = {{{{-16, -16, -36}, {16, 16, 36}, 1},
                                                    {{-32, -32, -32}, {32, 32, 32}, 2},
                                                    {{-16, -16, -18}, {16, 16, 18}, 1}}};

// Returns the Minkowski sum of the brush and the mirrored box: sides moved outward, plus bevels, axial planes
// and planes across edges, where the moved sides alone would reach too far. The result has no windings and no
// box yet: those take most of the time and the memory, but no new planes, so jobs make them later.
Brush expand(const Brush& brush, const HullBox& box, PlaneSet& io_planes);
// Makes the windings and the box of an expanded brush.
void add_windings(Brush& io_grown, const PlaneSet& planes);

}  // namespace temblor::compiler
