#include "net/protocol/powerup_end.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace temblor::net {

namespace {

constexpr std::string_view kPowerupPrefix = "//temblor powerup ";

}  // namespace

std::string format_powerup_end(const PowerupEnd& end) {
  return fmt::format("{}{} {}\n", kPowerupPrefix, end.bit, end.end_s);
}

bool is_powerup_end(std::string_view line) {
  return line.starts_with(kPowerupPrefix);
}

base::Result<PowerupEnd> read_powerup_end(std::string_view line) {
  PowerupEnd end;
  const char* const last = line.data() + line.size();
  const auto bit = std::from_chars(line.data() + kPowerupPrefix.size(), last, end.bit);
  if (bit.ec != std::errc{} || end.bit > PowerupEnd::kMaxBit || bit.ptr == last || *bit.ptr != ' ')
    return base::malformed("the bit of a power-up is not 0 to {}", PowerupEnd::kMaxBit);
  const auto time = std::from_chars(bit.ptr + 1, last, end.end_s);
  if (time.ec != std::errc{} || time.ptr != last || !std::isfinite(end.end_s))
    return base::malformed("the end of a power-up is not a time");
  return end;
}

}  // namespace temblor::net
