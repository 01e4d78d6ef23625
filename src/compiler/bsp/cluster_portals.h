// What is seen together, and the openings between.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/bsp/leaf_portals.h"
#include "compiler/vis/portals.h"

namespace temblor::compiler {

// What structure leaves whole is a cluster, however detail splits it. `leaf_numbers`: of the tree's leaves in
// the level, 0 for solid ones; `leaf_count`: of the whole level.
PortalSet make_cluster_portals(const Tree& tree, const PlaneSet& planes,
                               std::span<const std::uint32_t> leaf_numbers, std::size_t leaf_count,
                               bool water_is_transparent);

}  // namespace temblor::compiler
