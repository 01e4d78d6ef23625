// Counts heap allocations, to show that a warm frame makes none. Replaces the global operator new.
#pragma once

#include <cstdint>

namespace temblor::app {

// Returns the number of calls of operator new in all threads since the program started.
std::uint64_t allocation_count();

}  // namespace temblor::app
