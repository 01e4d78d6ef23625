// What a compilation tells the person at work: how far it is, and what it found wrong but could live with.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/function_ref.h"

namespace temblor::compiler {

// Called with how much of a stage is done, of how much; by one thread at a time. False: stop here.
using Progress = base::FunctionRef<bool(std::size_t done, std::size_t total)>;

inline constexpr auto kNobodyWatches = [](std::size_t, std::size_t) { return true; };

struct Warning {
  std::string kind;  // the same for all that are grouped: "texture not found"
  std::string what;  // names entity, brush and line where there is one
};

using Warnings = std::vector<Warning>;

}  // namespace temblor::compiler
