#include "formats/models/group_time.h"

#include <algorithm>
#include <cmath>

namespace temblor::formats {

std::size_t find_group_member(std::span<const float> end_times_s, double time_s) {
  if (end_times_s.empty()) return 0;
  // In double precision: after days of play, a float cannot represent tenths of a second.
  const double period_s = end_times_s.back();
  double within_s = std::fmod(time_s, period_s);
  if (within_s < 0) within_s += period_s;
  const auto next_end =
      std::ranges::upper_bound(end_times_s, within_s, {}, [](float end) { return double{end}; });
  // For tiny negative times, the sum above rounds up to the period itself.
  return std::min(static_cast<std::size_t>(next_end - end_times_s.begin()), end_times_s.size() - 1);
}

bool are_group_times(std::span<const float> end_times_s) {
  float last_s = 0;
  for (const float end_s : end_times_s) {
    if (!std::isfinite(end_s) || end_s <= last_s) return false;
    last_s = end_s;
  }
  return true;
}

}  // namespace temblor::formats
