// Saved games (.sav), version 5: text, as stock engines write and read it.
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

// Names and values, as the file has them.
using SavPairs = std::vector<std::pair<std::string, std::string>>;

struct Sav {
  std::string comment;  // shown in menus; at most kSavCommentChars
  std::array<float, kSavParameters> spawn_parameters{};
  int skill = 1;
  std::string map;  // "e1m1"
  float time_s = 0;
  std::array<std::string, kSavLightStyles> light_styles;
  SavPairs globals;
  std::vector<SavPairs> entities;  // by number; empty: not in use
  bool operator==(const Sav&) const = default;
};

// Errors name the line. Engines of today append blocks and comments of their own behind the entities; a
// comment from // to the line's end is passed over.
base::Result<Sav> read_sav(std::string_view text);

// kUsage for a value that would end its own line or quotes.
base::Result<std::string> write_sav(const Sav& sav);

}  // namespace temblor::formats
