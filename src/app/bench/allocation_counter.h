// Counts what the program asks of the heap, to show that a warm frame asks for nothing.
#pragma once

#include <cstdint>

namespace temblor::app {

// Calls of operator new, in all threads, since the program started.
std::uint64_t allocation_count();

}  // namespace temblor::app
