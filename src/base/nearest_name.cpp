#include "base/nearest_name.h"

#include <algorithm>
#include <vector>

namespace temblor::base {

// By dynamic programming: the table holds the distances of all prefixes.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return table[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const std::size_t replaced = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({replaced, at(i - 1, j) + 1, at(i, j - 1) + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  return table.back();
}

std::optional<std::string_view> find_nearest_name(std::string_view misspelled,
                                                  std::span<const std::string_view> names) {
  std::optional<std::string_view> nearest;
  std::size_t least = std::max<std::size_t>(1, misspelled.size() / 4) + 1;
  for (const std::string_view name : names)
    if (const std::size_t distance = edit_distance(misspelled, name); distance < least) {
      least = distance;
      nearest = name;
    }
  return nearest;
}

}  // namespace temblor::base
