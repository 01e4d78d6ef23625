#include "net/protocol/team_captures.h"

#include <optional>

#include "base/words.h"

namespace temblor::net {

namespace {

constexpr std::string_view kCapturesPrefix = "//temblor captures ";

}  // namespace

bool is_team_captures(std::string_view line) {
  return line.starts_with(kCapturesPrefix);
}

base::Result<TeamCaptures> read_team_captures(std::string_view line) {
  line.remove_prefix(kCapturesPrefix.size());
  const std::size_t space = line.find(' ');
  const auto color = base::parse_number<std::uint8_t>(line.substr(0, space));
  if (!color || *color > TeamCaptures::kMaxColor || space == std::string_view::npos)
    return base::malformed("the color of a team is not 0 to {}", TeamCaptures::kMaxColor);
  const auto count = base::parse_number<std::int16_t>(line.substr(space + 1));
  if (!count || *count < 0) return base::malformed("the captures are not a count");
  return TeamCaptures{*color, *count};
}

}  // namespace temblor::net
