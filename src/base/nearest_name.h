// Suggestions for misspelled names, by the distance of Damerau and Levenshtein.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace temblor::base {

// Returns the number of edits that turn one text into the other: inserting, removing, or replacing a
// character, or swapping two neighbors that are not edited otherwise.
std::size_t edit_distance(std::string_view a, std::string_view b);

// Returns the name with the smallest distance, the first one of several; nothing if all differ in more than
// one character and a quarter of `misspelled`.
std::optional<std::string_view> find_nearest_name(std::string_view misspelled,
                                                  std::span<const std::string_view> names);

}  // namespace temblor::base
