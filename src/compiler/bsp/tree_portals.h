// The portals of a finished level, made from its tree, so that visibility can be computed for any .bsp.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// Points nearer to a plane than this (units) are on it, so a narrower opening is no portal. A .bsp stores
// planes as floats, whose error at 4096 units is up to a thousandth.
constexpr double kTreePortalEpsilon = 0.01;

// A level with more portals is an error; known levels have fewer than 100,000.
constexpr std::size_t kMaxTreePortals = 2'000'000;

// Which leaves of a finished level count as one cluster.
enum class Clusters {
  kEveryLeaf,  // each leaf is a cluster
  // Neighboring leaves that share one row of visibility are one cluster: compilers leave the leaves that
  // func_detail split that way. Without visibility, the same as kEveryLeaf.
  kSharedVisibility,
};

// How to read the level.
struct TreePortalSettings {
  bool liquids_see_through = true;  // false: the surfaces of water, slime and lava block the view
  Clusters clusters = Clusters::kEveryLeaf;
};

// Whether one can see from a leaf with one kind of contents (formats::BspLeaf::contents) into a neighbor with
// another. Nothing sees into or out of solid, and the surface of the sky blocks the view from both sides.
bool can_see_through(std::int32_t from, std::int32_t to, bool liquids_see_through);

// Makes the portals between the leaves of the world's drawn hull, in the order of the tree. `bsp` passed
// validation. Clusters are numbered by their lowest leaf; leaves that are solid or belong to other models
// have none. Where the level is open to the void, portals end 2^20 units from the origin. Fails with
// kTooLarge beyond kMaxTreePortals.
base::Result<PortalSet> make_tree_portals(const formats::Bsp& bsp, const TreePortalSettings& settings = {});

}  // namespace temblor::compiler
