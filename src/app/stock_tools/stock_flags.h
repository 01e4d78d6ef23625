// The flags of the stock tools, one table for each tool.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "app/stock_tools/stock_command.h"

namespace temblor::app {

// The words that follow a flag.
enum class FlagValues : std::uint8_t {
  kNone,
  kNumber,
  kOptionalNumber,  // counts as 1 if the next word is not a number
  kThreeNumbers,
  kText,
};

using FlagWords = std::span<const std::string>;

// A flag without its dash. Either `apply` is set, or the flag changes nothing: then `note` says what Temblor
// does instead, or is null if there is nothing to say.
struct StockFlag {
  const char* name;
  FlagValues values = FlagValues::kNone;
  void (*apply)(FlagWords values, StockCommand& io_command) = nullptr;
  const char* note = nullptr;
  bool is_refused = false;  // the result would not be what the mapper asked for; `note` says why
};

// The flags of one tool, then those of all tools.
std::span<const StockFlag> list_tool_flags(StockTool tool);
std::span<const StockFlag> list_common_flags();

// Parses a finite number that is the whole word.
std::optional<double> parse_flag_number(std::string_view word);

}  // namespace temblor::app
