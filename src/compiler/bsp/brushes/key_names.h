// The names of all entity keys that the compiler, ericw-tools, or an engine reads with an underscore in
// front.
#pragma once

#include <span>
#include <string_view>

namespace temblor::compiler {

// Sorted, without the underscore. Add a key here when the compiler learns it: keys that are not in the list
// cause a warning.
std::span<const std::string_view> known_key_names();

}  // namespace temblor::compiler
