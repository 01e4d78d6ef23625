// Solids that cover the walls of a space but leave its openings to other spaces free. They are made after all
// spaces are known.
#pragma once

#include <vector>

#include "artgen/level_script/level_script.h"

namespace temblor::artgen {

// A grid of triangular prisms on one side of a space. Their fronts bulge into it by noise of up to `rough`
// units and sink to the wall near openings.
std::vector<Solid> make_rock(const RockFace& face, const std::vector<Space>& spaces);

// Boxes along one wall.
std::vector<Solid> make_band(const Band& band, const std::vector<Space>& spaces);

// Value noise in [0, 1) with cells of one unit. Deterministic.
double smooth_noise(double x, double y, std::uint64_t seed);

}  // namespace temblor::artgen
