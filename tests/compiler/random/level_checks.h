// Brushes of a map against its compiled level, for maps that nobody has checked by hand.
#pragma once

#include <utility>
#include <vector>

#include "compiler/bsp/brush_boxes.h"
#include "compiler/bsp/make_draft.h"
#include "compiler/vis/visibility.h"
#include "world/trace.h"

namespace temblor::test {

// Points nearer to a brush than this, and rays that pass one as closely, are left out: rounding decides.
constexpr double kUnsure = 0.1;  // units

// The hulls of a level, and the boxes that they stand for; the first is a point.
extern const std::vector<std::pair<world::Hull, HullBox>> kHullBoxes;

// All textures have 64 x 64 texels.
compiler::DraftResult compile_map(const formats::Map& map, int threads);

// The full search.
compiler::BitMatrix find_visibility(const compiler::PortalSet& portals, int threads);

// How deep the box is in any of the solids; negative: how far it is from all of them, or -1e9 if it is far.
double depth_in_any(const std::vector<Solid>& solids, const HullBox& box, const math::Vec3d& at);

// Whether the level stops the hull's box at this place. Sky does.
bool is_solid(const world::Level& level, world::Hull hull, const math::Vec3d& at);

}  // namespace temblor::test
