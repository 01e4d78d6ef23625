// Names of the places of a level (.loc), which players use to tell their team where they are. Two styles, of
// QuakeWorld clients and of ProQuake, which may be mixed line by line:
//
//   X Y Z NAME                        a point, in eighths of a unit
//   X1,Y1,Z1,X2,Y2,Z2,"NAME"          a box, in units, by two opposite corners
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace temblor::formats {

struct Location {
  std::string name;  // at most 64 printable characters
  math::Bounds box;  // without a size for a point
};

// Reads at most 4096 locations. Lines of neither style are skipped. Macros of QuakeWorld clients in names
// become text: "$loc_name_ra" becomes "ra", and "$loc_name_separator" becomes "-".
std::vector<Location> read_locations(std::string_view text);

// Returns the location that contains the point, of several the smallest; otherwise the nearest. Null if there
// are no locations.
const Location* find_location(std::span<const Location> locations, const math::Vec3& point);

}  // namespace temblor::formats
