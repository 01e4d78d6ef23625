#include "net/protocol/team_captures.h"

#include <charconv>

namespace temblor::net {

namespace {

constexpr std::string_view kCapturesPrefix = "//temblor captures ";

}  // namespace

bool is_team_captures(std::string_view line) {
  return line.starts_with(kCapturesPrefix);
}

base::Result<TeamCaptures> read_team_captures(std::string_view line) {
  TeamCaptures captures;
  const char* const last = line.data() + line.size();
  const auto color = std::from_chars(line.data() + kCapturesPrefix.size(), last, captures.color);
  if (color.ec != std::errc{} || captures.color > TeamCaptures::kMaxColor || color.ptr == last ||
      *color.ptr != ' ')
    return base::malformed("the color of a team is not 0 to {}", TeamCaptures::kMaxColor);
  const auto count = std::from_chars(color.ptr + 1, last, captures.count);
  if (count.ec != std::errc{} || count.ptr != last || captures.count < 0)
    return base::malformed("the captures are not a count");
  return captures;
}

}  // namespace temblor::net
