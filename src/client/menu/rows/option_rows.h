// Rows that show console variables and set them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "client/menu/rows/row.h"
#include "command/variables.h"

namespace temblor::client {

// How a variable is shown. `low`, `high` and `step` are of a slider; with low == high it spans the variable's
// own range in 20 steps.
struct OptionLook {
  std::string_view variable, label;
  double low = 0, high = 0, step = 0;
  double shown_factor = 1;
  std::string_view unit = "";
  std::string_view zero = "";                    // what the value 0 is called
  std::span<const std::string_view> names = {};  // of the values 0, 1, ...: a choice in place of a slider
};

// On and off, a choice, a slider or a text, as the variable's type asks for; null where there is no such
// variable. Changes are set at once. The help is the variable's.
std::unique_ptr<Row> make_option_row(command::Variables& io_variables, const OptionLook& look);

// One of the 14 colors of players' clothes; null where there is no such whole number.
std::unique_ptr<Row> make_color_row(command::Variables& io_variables, const OptionLook& look);

}  // namespace temblor::client
