// Frames and skins of models and sprites that play by themselves.
#pragma once

#include <cstddef>
#include <span>

namespace temblor::formats {

// Which of a group's members shows at `time_s` (finite, any sign): the group repeats after its last end. 0
// for an empty list (no group).
std::size_t group_member_at(std::span<const float> end_times_s, double time_s);

// What may stand as a group's end times: finite, above zero, each greater than the one before.
bool are_group_times(std::span<const float> end_times_s);

}  // namespace temblor::formats
