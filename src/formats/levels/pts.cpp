#include "formats/levels/pts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/text.h"

namespace temblor::formats {
namespace {

constexpr std::string_view kSpace = " \t\r";

// Removes the first word from the text and returns it.
std::string_view take_word(std::string_view& io_text) {
  io_text.remove_prefix(std::min(io_text.find_first_not_of(kSpace), io_text.size()));
  const std::string_view word = io_text.substr(0, io_text.find_first_of(kSpace));
  io_text.remove_prefix(word.size());
  return word;
}

std::optional<float> parse_coordinate(std::string_view word) {
  float number = 0;
  const char* const end = word.data() + word.size();
  const auto [after, code] = std::from_chars(word.data(), end, number);
  return code == std::errc{} && after == end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

base::Result<std::vector<math::Vec3>> read_pts(std::string_view text) {
  std::vector<math::Vec3> points;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.find_first_not_of(kSpace) == std::string_view::npos) continue;
    std::string_view rest = line;
    math::Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::optional<float> coordinate = parse_coordinate(take_word(rest));
      if (!coordinate)
        return base::malformed("line {}: \"{}\" is not a point, expected three numbers", number,
                               base::quotable(line));
      point[axis] = *coordinate;
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace temblor::formats
