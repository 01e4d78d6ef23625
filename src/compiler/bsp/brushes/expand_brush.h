// Brushes for the clip hulls: grown by a box, so that tracing the box's origin against them is tracing the
// box.
#pragma once

#include "compiler/bsp/brushes/brush.h"

namespace temblor::compiler {

struct HullBox {
  math::Vec3d mins, maxs;
};
// Hulls 1 and 2: players and large monsters.
constexpr std::array<HullBox, 2> kHullBoxes = {
    {{{-16, -16, -24}, {16, 16, 32}}, {{-32, -32, -24}, {32, 32, 64}}}};

// The sum of the brush and the box turned round: its sides moved outwards, with planes across its corners and
// edges (bevels) where the moved sides alone would reach too far. Without windings and a box of its own,
// which take most of the time and of the memory, and need no new planes.
Brush expand(const Brush& brush, const HullBox& box, PlaneSet& io_planes);
void add_windings(Brush& io_grown, const PlaneSet& planes);

}  // namespace temblor::compiler
