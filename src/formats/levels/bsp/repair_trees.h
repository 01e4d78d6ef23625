// Repair of the trees of hull 0.
#pragma once

#include <cstddef>

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// Returns a head that is an empty leaf, or leaf 0 if there is none.
std::int32_t find_empty_leaf(const Bsp& bsp);

// Cuts branches that lead to a node that another branch has reached, or too deep: they lead to leaf 0. The
// head of a model that names a part of another model's tree becomes an empty leaf. Ignores heads that do not
// exist; requires that all children exist. Returns the number of changes.
std::size_t repair_node_trees(Bsp& io_bsp);

}  // namespace temblor::formats::bsp_file
