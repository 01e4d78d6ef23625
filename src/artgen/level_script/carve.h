// The shell around a plan's spaces: what makes the level closed.
#pragma once

#include <span>
#include <vector>

#include "artgen/level_script/plan.h"

namespace temblor::artgen {

constexpr int kShellThickness = 16;

// Boxes that fill every place nearer than kShellThickness to a space and in none, corners included. A side of
// one that borders on a space looks as that space wants it there, where spaces overlap as the last of them.
std::vector<Solid> carve_shell(std::span<const Space> spaces);

// Whether every point of the box is in a space.
bool is_open(std::span<const Space> spaces, const Box& box);

}  // namespace temblor::artgen
