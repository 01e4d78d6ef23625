// Formats completion candidates (command/completion.h) for the console.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "command/completion.h"

namespace temblor::client {

// The longest common prefix of the names, ignoring case, spelled as in the first one; empty for no names.
std::string find_common_prefix(std::span<const command::Candidate> candidates);

// Formats a line for each candidate: its name in bronze, its value, and its help, in console characters.
// Lists at most 100, and then how many more there are.
std::string format_candidates(std::span<const command::Candidate> candidates);

}  // namespace temblor::client
