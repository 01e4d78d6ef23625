// The techniques of the laboratory.
#pragma once

#include <string_view>

#include "base/result.h"
#include "lab/technique.h"

namespace temblor::lab {

// In the order of the laboratory's book. The first is the engine itself.
std::span<const Technique> list_techniques();

// Technique `number` of the list, with the defaults of its parameters.
Choice make_default_choice(std::size_t number);

// Parses "NAME" or "NAME:PARAMETER=VALUE,PARAMETER=VALUE". Errors are kUnsupported: an unknown name, an
// unknown parameter, a value out of range.
base::Result<Choice> parse_choice(std::string_view text);

}  // namespace temblor::lab
