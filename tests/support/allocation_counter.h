// Counts the heap allocations of a test program. Its source file replaces operator new, only in programs that
// call it.
#pragma once

#include <cstddef>

namespace temblor::test {

// Returns the number of calls of operator new, in any form and on any thread, since the program started.
std::size_t allocation_count();

}  // namespace temblor::test
