#include "app/bench/comparison.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace temblor::app {

// Both runs of a round see a similar state of the machine, so the ratio is taken by round.
Spread compute_ratio(const Comparison& comparison) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < comparison.fps.size(); ++round)
    ratios.push_back(comparison.fps[round] / comparison.other_fps[round]);
  return compute_spread(std::move(ratios));
}

std::string describe_last_round(const Comparison& comparison) {
  const double fps = comparison.fps.back(), other_fps = comparison.other_fps.back();
  return fmt::format("  round {}: {:.1f} fps, the command {:.1f} fps: {:.2f} times as fast\n",
                     comparison.fps.size(), fps, other_fps, fps / other_fps);
}

std::string describe_ratio(const Comparison& comparison) {
  const Spread ratio = compute_ratio(comparison);
  return fmt::format("  median ratio {:.2f}, {:.2f} to {:.2f}\n", ratio.median, ratio.min, ratio.max);
}

// The command may have bytes that are not UTF-8, which JSON cannot hold; dump() replaces them.
nlohmann::json make_json(const Comparison& comparison) {
  const Spread ratio = compute_ratio(comparison);
  return {{"command", comparison.command},
          {"fps", comparison.fps},
          {"other_fps", comparison.other_fps},
          {"ratio", {{"median", ratio.median}, {"min", ratio.min}, {"max", ratio.max}}}};
}

}  // namespace temblor::app
