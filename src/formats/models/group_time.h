// Animated groups: frames and skins of models and sprites that play without game code, such as flames. Each
// member has the time at which it ends, from the start of the group:
//
//   end times 0.1, 0.3, 0.4:   | member 0 |    member 1    | member 2 | member 0 | ...
//                              0         0.1              0.3        0.4        0.5 s
#pragma once

#include <cstddef>
#include <span>

namespace temblor::formats {

// Returns the index of the group member that is visible at `time_s` (finite, any sign). The group repeats
// after its last end time. Returns 0 for an empty list (no group). The end times must be valid.
std::size_t find_group_member(std::span<const float> end_times_s, double time_s);

// Returns whether the end times are valid: finite, positive, and strictly increasing.
bool are_group_times(std::span<const float> end_times_s);

}  // namespace temblor::formats
