// Values of model scripts that consist of several numbers, and bone names that stand for a left and a right
// bone.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace temblor::artgen {

// "1,2.5,3" as numbers; nothing if the text contains anything else.
std::optional<std::vector<double>> parse_numbers(std::string_view text, char between = ',');

// A star stands for both sides: "arm_*" is arm_l and arm_r.
bool is_pair(std::string_view name);
// Replaces the star by `side`, 'l' or 'r'. Names without a star stay the same.
std::string select_side(std::string_view name, char side);
// arm_r for arm_l and the reverse; names without such an ending stay the same. `name` must not be empty.
std::string mirror_name(std::string_view name);

}  // namespace temblor::artgen
