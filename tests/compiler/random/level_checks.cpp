#include "compiler/random/level_checks.h"

#include <algorithm>

namespace temblor::test {

using math::Vec3d;

const std::vector<std::pair<world::Hull, HullBox>> kHullBoxes = {
    {world::Hull::kPoint, {Vec3d(0.0), Vec3d(0.0)}},
    {world::Hull::kPlayer, {{-16, -16, -24}, {16, 16, 32}}},
    {world::Hull::kLarge, {{-32, -32, -24}, {32, 32, 64}}}};

compiler::DraftResult compile_map(const formats::Map& map, int threads) {
  base::Jobs jobs(threads);
  compiler::Warnings warnings;
  return compiler::make_draft(
             map, [](std::string_view) { return math::Vec2d(64, 64); }, {}, jobs, warnings)
      .value();
}

compiler::BitMatrix find_visibility(const compiler::PortalSet& portals, int threads) {
  base::Jobs jobs(threads);
  compiler::VisibilityState state = compiler::begin_visibility(portals);
  compiler::continue_visibility(portals, jobs, compiler::kIgnoreProgress, state);
  return compiler::find_visible_clusters(portals, state);
}

double depth_in_any(const std::vector<Solid>& solids, const HullBox& box, const Vec3d& at) {
  double deepest = -1e9;
  for (const Solid& solid : solids)
    if (glm::all(glm::greaterThan(at + box.maxs, solid.mins - 1.0)) &&
        glm::all(glm::lessThan(at + box.mins, solid.maxs + 1.0)))
      deepest = std::max(deepest, depth_in(solid, box, at));
  return deepest;
}

bool is_solid(const world::Level& level, world::Hull hull, const Vec3d& at) {
  const world::Contents contents = world::hull_contents(level, world::ModelIndex{0}, hull, math::Vec3(at));
  return contents == world::Contents::kSolid || contents == world::Contents::kSky;
}

}  // namespace temblor::test
