// The movement of the space battle: each solid's place is a function of the time.
//
// Ships chase each other around rings that have a common axis. Neighboring rings turn in opposite directions.
// A ring is divided into slots, which move with it; each solid stays in its own and sways and turns there.
// Slots are at least `spacing` apart in all directions, so solids of radius 1 never touch.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formats/images/palette.h"
#include "lab/space_battle/solid.h"
#include "math/angles.h"

namespace temblor::lab::space {

// A solid's own axes in space: x is forward, y left, z up.
struct Placement {
  math::Vec3d center{0.0};
  math::Basis axes;
};

// Lengths are in units of the largest solid's radius, angles in radians, times in seconds.
struct FormationSlot {
  std::uint32_t solid = 0;  // index of its shape
  formats::Rgb color{};
  double ring_radius = 0, ring_height = 0, angle = 0;
  double speed_rad_s = 0;  // around the ring; forward is the direction in which it moves
  double sway = 0, phase = 0;
  double roll_rad_s = 0, yaw_rad_s = 0;
  double shot_range = 0;  // not 0: flies through the slot from -shot_range to shot_range again and again
};

// At least this far apart, solids never touch.
constexpr double kSafeSpacing = 3;

struct Formation {
  std::vector<FormationSlot> slots;
  // A place outside of all rings, and near them.
  math::Vec3d lookout{0.0};
};

// `ships` are indices of shapes to choose from; a third of the solids are shots. The same seed gives the same
// formation.
Formation make_formation(std::size_t count, std::span<const std::uint32_t> ships, std::uint32_t shot,
                         double spacing, std::uint64_t seed);

Placement find_placement(const FormationSlot& slot, double time_s);

}  // namespace temblor::lab::space
