#include "formats/levels/locations.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>

namespace temblor::formats {
namespace {

constexpr std::size_t kMaxLocations = 4096, kMaxNameChars = 64;
constexpr std::string_view kLocationBlanks = " \t\r";
constexpr float kMaxCoordinate = 1 << 20;
constexpr float kStepsPerUnit = 8;  // of points

void skip_blanks(std::string_view& io_text) {
  io_text.remove_prefix(std::min(io_text.find_first_not_of(kLocationBlanks), io_text.size()));
}

// Removes a number from the front of the text; nothing if there is none, or if it is out of range.
std::optional<float> take_number(std::string_view& io_text) {
  skip_blanks(io_text);
  if (io_text.starts_with('+')) io_text.remove_prefix(1);
  float number = 0;
  const auto [end, code] = std::from_chars(io_text.data(), io_text.data() + io_text.size(), number);
  if (code != std::errc{} || !(std::abs(number) <= kMaxCoordinate)) return std::nullopt;
  io_text.remove_prefix(static_cast<std::size_t>(end - io_text.data()));
  return number;
}

// Removes quotes and the macros of QuakeWorld clients.
std::string clean_name(std::string_view text) {
  constexpr std::string_view kMacro = "$loc_name_", kSeparator = "separator";
  std::string name;
  while (!text.empty() && name.size() < kMaxNameChars) {
    if (text.starts_with(kMacro)) {
      text.remove_prefix(kMacro.size());
      if (text.starts_with(kSeparator)) {
        text.remove_prefix(kSeparator.size());
        name += '-';
      }
      continue;
    }
    const char c = text.front();
    text.remove_prefix(1);
    if (c >= ' ' && c <= '~' && c != '"') name += c;
  }
  name.erase(name.find_last_not_of(' ') + 1);
  return name;
}

std::optional<Location> read_location(std::string_view line) {
  std::array<float, 6> numbers{};
  std::size_t count = 0;
  bool has_commas = false;
  while (count < numbers.size() && (count < 3 || has_commas)) {
    const std::optional<float> number = take_number(line);
    if (!number) return std::nullopt;
    numbers[count++] = *number;
    skip_blanks(line);
    if (line.starts_with(',')) {
      has_commas = true;
      line.remove_prefix(1);
    }
  }
  skip_blanks(line);
  Location location{clean_name(line), {}};
  if (location.name.empty()) return std::nullopt;
  const math::Vec3 first(numbers[0], numbers[1], numbers[2]), second(numbers[3], numbers[4], numbers[5]);
  location.box = has_commas ? math::Bounds{glm::min(first, second), glm::max(first, second)}
                            : math::Bounds{first / kStepsPerUnit, first / kStepsPerUnit};
  return location;
}

}  // namespace

std::vector<Location> read_locations(std::string_view text) {
  std::vector<Location> locations;
  while (!text.empty() && locations.size() < kMaxLocations) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (std::optional<Location> location = read_location(line)) locations.push_back(std::move(*location));
  }
  return locations;
}

const Location* find_location(std::span<const Location> locations, const math::Vec3& point) {
  // Distance first, then size.
  const auto rank = [&](const Location& location) {
    const math::Vec3 nearest = glm::clamp(point, location.box.mins, location.box.maxs);
    const math::Vec3 size = location.box.maxs - location.box.mins;
    return std::tuple(glm::distance(nearest, point), size.x * size.y * size.z);
  };
  const auto best = std::ranges::min_element(locations, {}, rank);
  return best == locations.end() ? nullptr : &*best;
}

}  // namespace temblor::formats
