// The words of the choice that the tests of variables use.
#pragma once

#include <array>
#include <string_view>

namespace temblor::command {

inline constexpr std::array<std::string_view, 3> kColors = {"red", "green", "blue"};

}  // namespace temblor::command
