// Validates the trees of a level: no cycles, no node reached twice (so walks take linear time), and a bounded
// depth (so recursion is safe).
#pragma once

#include <optional>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {

// Return the first fault, or nullopt. Both require that all children and heads are in range.
std::optional<BspFault> check_node_trees(const Bsp& bsp);
std::optional<BspFault> check_clipnode_trees(const Bsp& bsp);

}  // namespace temblor::formats::bsp_file
