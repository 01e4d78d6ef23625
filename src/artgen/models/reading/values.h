// Words of model scripts that are more than one number, and names that stand for a left and a right.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace temblor::artgen {

// "1,2.5,3"; nothing where anything else stands.
std::optional<std::vector<double>> numbers_in(std::string_view text, char between = ',');

// "arm_*" stands for arm_l and arm_r.
bool is_pair(std::string_view name);
std::string on_side(std::string_view name, char side);  // 'l' or 'r'; other names stay
// arm_l for arm_r and the other way round; other names stay.
std::string mirrored_name(std::string_view name);

}  // namespace temblor::artgen
