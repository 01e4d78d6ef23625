// What a word could become, for a person to read.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "command/completion.h"

namespace temblor::client {

// What the names have in common from their beginning on, without regard to case, spelled as the first is.
std::string common_beginning(std::span<const command::Candidate> candidates);

// A line each, names in bronze, with values and help; of very many the first, and how many more there are.
std::string list_candidates(std::span<const command::Candidate> candidates);

}  // namespace temblor::client
