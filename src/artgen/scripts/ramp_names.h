// The names of the palette's ramps in art scripts.
#pragma once

#include <array>
#include <string_view>

namespace temblor::artgen {

// In the order of Ramp.
constexpr std::array<std::string_view, 16> kRampNames = {
    "gray", "brown",  "brick", "sand", "red",  "olive", "gold", "teal",
    "blue", "purple", "slate", "rust", "skin", "green", "fire", "electric"};

}  // namespace temblor::artgen
