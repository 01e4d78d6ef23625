// What covers the sides of a space and leaves its openings free: made when all spaces are known.
#pragma once

#include <vector>

#include "artgen/level_script/plan.h"

namespace temblor::artgen {

// Prisms whose fronts bulge into the space by noise between 8 and `rough` units, and sink to none at
// openings.
std::vector<Solid> make_rock(const RockFace& face, const std::vector<Space>& spaces);

std::vector<Solid> make_band(const Band& band, const std::vector<Space>& spaces);

// Between 0 and 1, smooth over one unit; the same everywhere.
double smooth_noise(double x, double y, std::uint64_t seed);

}  // namespace temblor::artgen
