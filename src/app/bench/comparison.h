// Formats the comparison with another program, for `temblor bench --against`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/bench/distribution.h"

namespace temblor::app {

// Frames per second of both programs in alternating runs, one element per round.
struct Comparison {
  std::string command;
  std::vector<double> fps, other_fps;
};

// Returns the spread of our frame rate divided by the other one, over the rounds.
Spread compute_ratio(const Comparison& comparison);

// Returns the line of the last round, and the line with the ratio of all rounds.
std::string describe_last_round(const Comparison& comparison);
std::string describe_ratio(const Comparison& comparison);

// Returns command, fps [by round], other_fps [by round], ratio {median, min, max}.
nlohmann::json make_json(const Comparison& comparison);

}  // namespace temblor::app
