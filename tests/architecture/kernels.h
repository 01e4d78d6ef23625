// Rules about SIMD code. Each function returns one line for each violation; an empty list means that the rule
// holds.
#pragma once

#include <string>
#include <vector>

#include "architecture/source_tree.h"

namespace temblor::test {

// Only kernel folders use Highway, and nothing uses the intrinsics of one instruction set. A file that is
// compiled once per instruction set includes none of our function bodies, directly or indirectly: the linker
// might keep the copy compiled for a newer processor, which crashes an older one.
std::vector<std::string> find_kernel_violations(const std::vector<SourceFile>& files);

}  // namespace temblor::test
