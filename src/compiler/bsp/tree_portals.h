// The portals of a level from its finished tree, so that visibility can be worked out for any .bsp.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// Shorter distances, in units, do not tell a point from a plane: an opening narrower than this is none. A
// .bsp holds planes as floats, which at 4096 units are off by up to a thousandth.
constexpr double kTreePortalEpsilon = 0.01;

// More portals than this are an error: known levels have below 100,000.
constexpr std::size_t kMaxTreePortals = 2'000'000;

enum class Clusters {
  kEveryLeaf,  // by itself
  // Neighbors whose visibility begins at the same offset are one cluster: so compilers leave the leaves that
  // func_detail split. In a level without visibility, as kEveryLeaf.
  kSharedVisibility,
};

struct TreePortalSettings {
  bool liquids_see_through = true;  // false: water, slime and lava end at their surface what can be seen
  Clusters clusters = Clusters::kEveryLeaf;
};

// What a leaf's contents let pass: nothing goes in or out of solid; the surface of the sky hides what lies
// behind it from both sides.
bool contents_see_through(std::int32_t from, std::int32_t to, bool liquids_see_through);

// The portals between the leaves of the world's hull 0 (`bsp` was validated), in an order given by the tree.
// Clusters are numbered by their lowest leaf; leaves that are solid or not the world's have none. Where the
// level is open to the void, portals end 2^17 units from the origin.
base::Result<PortalSet> make_tree_portals(const formats::Bsp& bsp, const TreePortalSettings& settings = {});

}  // namespace temblor::compiler
