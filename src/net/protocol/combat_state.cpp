#include "net/protocol/combat_state.h"

#include <fmt/format.h>

namespace temblor::net {

namespace {

constexpr std::string_view kCombatPrefix = "//temblor combat ";

}  // namespace

std::string format_combat_state(bool is_hunted) {
  return fmt::format("{}{}\n", kCombatPrefix, is_hunted ? 1 : 0);
}

bool is_combat_state(std::string_view line) {
  return line.starts_with(kCombatPrefix);
}

base::Result<bool> read_combat_state(std::string_view line) {
  line.remove_prefix(kCombatPrefix.size());
  if (line != "0" && line != "1") return base::malformed("the combat state is not 0 or 1");
  return line == "1";
}

}  // namespace temblor::net
