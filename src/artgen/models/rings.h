// Closed surfaces that consist of rings along a line: tubes, balls, spikes, crystals. Consecutive rings are
// connected by quads (two triangles each); the ends are closed by a flat cap or a rounded tip.
//
//   first end  ring 0   ring 1   ring 2  last end
//       <-----(------)-(------)-(------)----->       each ring has `sides` corners
//
// The side surface is one chart: unrolled, with the line upward and the circumference across. Caps are charts
// of their own.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/models/mesh.h"
#include "math/vec.h"

namespace temblor::artgen {

// An ellipse around the line.
struct Ring {
  // In the model's coordinates.
  math::Vec3d center{0.0};
  // The radii sideways and across that. Both 0: a point, which only the first and the last ring may be.
  double width = 0, depth = 0;
  std::size_t bone_a = 0, bone_b = 0;
  double share_b = 0;
};

// Smoothing: everywhere, around the rings only (with crisp steps along the line), or nowhere.
enum class Edges { kSmooth, kRings, kHard };
// How an end is closed, unless it is a point.
enum class RingEnd { kRound, kFlat };

// The description of a surface.
struct RingSurface {
  std::vector<Ring> rings;  // at least two
  std::int32_t sides = 6;   // at least 3
  // Rotates the corners on their rings.
  double turn_deg = 0;
  Edges edges = Edges::kSmooth;
  RingEnd first_end = RingEnd::kRound, last_end = RingEnd::kRound;
};

// Appends the surface to the mesh as part of shape number `shape`. Rings are perpendicular to the line
// through their centers. Angle 0 is forward if the line is vertical, and up if it is horizontal. 90 is left,
// or forward if the line runs sideways.
void add_rings(const RingSurface& surface, std::uint32_t shape, Mesh& io_mesh);

}  // namespace temblor::artgen
