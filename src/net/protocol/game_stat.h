// A stat of a game's own, from number 32 on: a value that game code lets the server send to the HUD program
// of each player (docs/modding.md). It is a console comment in svc_stufftext, because stock clients end at an
// svc_updatestat above 31:
//
//   //temblor stat NUMBER i INTEGER
//   //temblor stat NUMBER f FLOAT
//   //temblor stat NUMBER s BASE64URL    text, encoded because it may contain line ends
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "base/result.h"

namespace temblor::net {

using StatValue = std::variant<std::int32_t, float, std::string>;

struct GameStat {
  static constexpr int kFirst = 32, kLast = 255;
  static constexpr std::size_t kMaxTextChars = 1024;  // longer texts are cut

  std::uint8_t number = kFirst;
  StatValue value{};
  bool operator==(const GameStat&) const = default;
};

// Formats a line for svc_stufftext, with its line end.
std::string format_game_stat(const GameStat& stat);
// Whether a line of stuffed text, without its line end, is meant as a stat.
bool is_game_stat(std::string_view line);
// Parses such a line. Errors say which part is wrong.
base::Result<GameStat> read_game_stat(std::string_view line);

}  // namespace temblor::net
