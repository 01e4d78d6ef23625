// Closed surfaces made of rings one after another: tubes, balls, spikes, crystals.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/models/mesh.h"
#include "math/vec.h"

namespace temblor::artgen {

struct Ring {
  math::Vec3d center{0.0};      // the model's space
  double width = 0, depth = 0;  // radii: sideways, and across that; both 0 in a point, at an end only
  std::size_t bone_a = 0, bone_b = 0;
  double share_b = 0;
};

enum class Edges { kSmooth, kRings, kHard };  // kRings: round, with crisp steps along
enum class RingEnd { kRound, kFlat };

struct RingSurface {
  std::vector<Ring> rings;  // at least two
  std::int32_t sides = 6;   // at least 3
  double turn_deg = 0;      // of the corners on their rings
  Edges edges = Edges::kSmooth;
  RingEnd first_end = RingEnd::kRound, last_end = RingEnd::kRound;
};

// Sections are square to the line through the rings' centers. Angle 0 is ahead for what stands or hangs,
// above for what lies; 90 is left (for what lies across: ahead).
void add_rings(const RingSurface& surface, std::uint32_t shape, Mesh& io_mesh);

}  // namespace temblor::artgen
