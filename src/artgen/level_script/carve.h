// Makes the shell: the brushes around all spaces of a script, which seal the level.
#pragma once

#include <span>
#include <vector>

#include "artgen/level_script/level_script.h"

namespace temblor::artgen {

// In units.
constexpr int kShellThickness = 16;

// Returns boxes that fill every point that is within kShellThickness of a space but in no space, including
// corners. Where a box borders on a space, it has the texture of that wall; where spaces overlap, the last
// one decides.
std::vector<Solid> carve_shell(std::span<const Space> spaces);

// Whether every point of the box lies in some space.
bool is_open(std::span<const Space> spaces, const Box& box);

}  // namespace temblor::artgen
