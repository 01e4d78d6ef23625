// Wedges: leaves between two planes that meet at a small angle, so that a leaf is wide at one end and too
// narrow to pass at the other. Sides of brushes that mappers meant to be parallel leave such gaps, and so do
// brushes whose thin pieces get lost when a tree is built.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bsp/planes.h"
#include "compiler/bsp/winding.h"

namespace temblor::compiler {

// A plane that bounds a leaf, facing outward, and the number of its node.
struct LeafPlane {
  Plane plane;
  std::uint32_t node;
};

struct Wedge {
  std::array<std::uint32_t, 2> nodes;  // of its two planes
  Plane limit;                         // behind it, the planes are at least the given opening apart
};

// Finds the first two planes that are nearer to each other than the opening (units) in one part of the leaf
// only. `corners` are those of the leaf's portals.
std::optional<Wedge> find_wedge(std::span<const LeafPlane> planes, std::span<const math::Vec3d> corners,
                                double min_opening_units);

}  // namespace temblor::compiler
