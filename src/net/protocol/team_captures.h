// The flags that a team has captured, for the table of scores. Game code sends it to each player as a console
// comment in svc_stufftext, which stock clients ignore:
//
//   //temblor captures COLOR COUNT
#pragma once

#include <cstdint>
#include <string_view>

#include "base/result.h"

namespace temblor::net {

struct TeamCaptures {
  static constexpr std::uint8_t kMaxColor = 15;

  std::uint8_t color = 0;  // of the team's pants
  std::int16_t count = 0;  // at least 0
  bool operator==(const TeamCaptures&) const = default;
};

// Whether a line of stuffed text, without its line end, is meant as such a count.
bool is_team_captures(std::string_view line);
// Parses such a line. Errors say which part is wrong.
base::Result<TeamCaptures> read_team_captures(std::string_view line);

}  // namespace temblor::net
