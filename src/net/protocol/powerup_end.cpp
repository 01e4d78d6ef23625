#include "net/protocol/powerup_end.h"

#include <fmt/format.h>

#include <optional>

#include "base/words.h"

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
  line.remove_prefix(kPowerupPrefix.size());
  const std::size_t space = line.find(' ');
  const auto bit = base::parse_number<std::uint8_t>(line.substr(0, space));
  if (!bit || *bit > PowerupEnd::kMaxBit || space == std::string_view::npos)
    return base::malformed("the bit of a power-up is not 0 to {}", PowerupEnd::kMaxBit);
  const auto end_s = base::parse_number<float>(line.substr(space + 1));
  if (!end_s) return base::malformed("the end of a power-up is not a time");
  return PowerupEnd{*bit, *end_s};
}

}  // namespace temblor::net
