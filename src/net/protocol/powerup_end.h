// When a power-up of the player ends, for the timers of the HUD. It is a console comment in svc_stufftext,
// which stock clients ignore:
//
//   //temblor powerup BIT TIME
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace temblor::net {

struct PowerupEnd {
  static constexpr std::uint8_t kMaxBit = 31;

  std::uint8_t bit = 0;  // of ClientData::items
  float end_s = 0;       // server time
  bool operator==(const PowerupEnd&) const = default;
};

// Formats a line for svc_stufftext, with its line end.
std::string format_powerup_end(const PowerupEnd& end);
// Whether a line of stuffed text, without its line end, is meant as such an end.
bool is_powerup_end(std::string_view line);
// Parses such a line. Errors say which part is wrong.
base::Result<PowerupEnd> read_powerup_end(std::string_view line);

}  // namespace temblor::net
