#include "artgen/models/reading/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace temblor::artgen {

std::optional<std::vector<double>> parse_numbers(std::string_view text, char between) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view part = text.substr(0, text.find(between));
    double value = 0;
    const auto [end, failure] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (failure != std::errc() || end != part.data() + part.size() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    if (part.size() == text.size()) return numbers;
    text.remove_prefix(part.size() + 1);
  }
}

bool is_pair(std::string_view name) {
  return name.find('*') != std::string_view::npos;
}

std::string select_side(std::string_view name, char side) {
  std::string sided(name);
  std::replace(sided.begin(), sided.end(), '*', side);
  return sided;
}

std::string mirror_name(std::string_view name) {
  std::string mirrored(name);
  const std::size_t at = mirrored.size() - 1;
  if (name.ends_with("_l")) mirrored[at] = 'r';
  if (name.ends_with("_r")) mirrored[at] = 'l';
  return mirrored;
}

}  // namespace temblor::artgen
