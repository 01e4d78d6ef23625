// Saved games (.sav), version 5, compatible with stock engines: the level, the globals of game code that are
// marked as saved, and the fields of all entities. Text, with one value in each line:
//
//   5                                  version
//   The_Copperworks____________________    comment: 39 characters, with '_' for spaces
//   0                                  16 lines: spawn parameters (what a player carries between levels)
//   1                                  skill
//   e1m1                               level
//   84.25                              server time in seconds
//   m                                  64 lines: light styles
//   {                                  one block of globals
//   "total_secrets" "6"
//   }
//   {                                  one block for each entity, in order; empty: unused
//   "classname" "worldspawn"
//   }
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace temblor::formats {

constexpr std::size_t kSavParameters = 16, kSavLightStyles = 64;
constexpr std::size_t kSavCommentChars = 39;

// Names and values as text, in file order. The game code's definitions give them types.
using SavPairs = std::vector<std::pair<std::string, std::string>>;

struct Sav {
  std::string comment;  // shown in menus; at most kSavCommentChars
  std::array<float, kSavParameters> spawn_parameters{};
  int skill = 1;     // 0 to 3
  std::string map;   // "e1m1"
  float time_s = 0;  // of the server
  std::array<std::string, kSavLightStyles> light_styles;
  SavPairs globals;
  std::vector<SavPairs> entities;  // by entity number; empty: unused
  bool operator==(const Sav&) const = default;
};

// Reads a saved game. Errors name the line. Skips empty lines before numbers and the level's name, and
// comments between blocks, from // to the end of the line and from /* to */: DarkPlaces writes a long one
// after the entities. A spawn parameter that is not finite becomes 0. The skill is rounded down after adding
// 0.1, and clamped to 0 to 3.
base::Result<Sav> read_sav(std::string_view text);

// Writes an empty light style as "m", as stock engines do: their readers skip empty lines. Returns kUsage if
// a value contains a line end or a quote.
base::Result<std::string> write_sav(const Sav& sav);

}  // namespace temblor::formats
