// Clusters, the units of visibility, and the portals between them.
//
// A cluster is a leaf of the tree that structural brushes make. Detail brushes (func_detail) split it into
// several leaves of the level, but those leaves see, and are seen, together: otherwise every pillar would
// multiply the work of the visibility stage.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/bsp/leaf_portals.h"
#include "compiler/vis/portals.h"

namespace temblor::compiler {

// Makes the portals for the visibility stage. `leaf_numbers`: by leaf of the tree, its number in the level, 0
// for solid leaves. `leaf_count`: of the whole level, other models included. If `water_is_transparent` is
// false, the surfaces of liquids have no portals.
PortalSet make_cluster_portals(const Tree& tree, const PlaneSet& planes,
                               std::span<const std::uint32_t> leaf_numbers, std::size_t leaf_count,
                               bool water_is_transparent);

}  // namespace temblor::compiler
