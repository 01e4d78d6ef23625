// The plan of a level from above, as SVG: a heat map of how much is visible from each place, the walls, the
// portals, and the path of a leak.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/compile/report/level_figures.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/report.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::app {

struct PlanInput {
  const world::Level& level;
  const compiler::PortalSet& portals;
  // By leaf (count_visible_leaves()); empty: there is no heat map.
  const std::vector<std::uint32_t>& visible_leaves;
  const std::vector<BusyPlace>& busy_places;  // numbered from 1 on the plan
  const std::optional<compiler::LeakPath>& leak;
};

// Returns an <svg> element with groups of the classes "heat", "walls", "portals", "places", and "leak". North
// (positive y) is at the top. The heat map has one pixel for each vertical line through the level, in the
// color of the leaf on it that sees the most.
base::Result<std::string> draw_level_plan(const PlanInput& input);

// The color of the heat map, 0xffRRGGBB, for a share of the largest count (0 to 1), from dark blue to yellow.
std::uint32_t heat_color(double share);

}  // namespace temblor::app
