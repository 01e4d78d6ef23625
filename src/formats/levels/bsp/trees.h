// The shape of a level's trees: no cycles, nothing reached twice where a walk must end in linear time, and
// no path so long that recursion could exhaust the stack.
#pragma once

#include <optional>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {

// Both need every child and head in range.
std::optional<BspFault> check_node_trees(const Bsp& bsp);
std::optional<BspFault> check_clipnode_trees(const Bsp& bsp);

}  // namespace temblor::formats::bsp_file
