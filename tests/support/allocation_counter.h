// Counts what a test program asks the heap for: its source file replaces operator new, in the programs that
// call it and in no other.
#pragma once

#include <cstddef>

namespace temblor::test {

// Calls of operator new in any form, on any thread, since the program began.
std::size_t allocation_count();

}  // namespace temblor::test
