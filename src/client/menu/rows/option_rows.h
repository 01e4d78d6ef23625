// Rows that show console variables and set them. The variable's type decides the kind of row: on/off, a
// choice, a slider, or a text field.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "client/menu/rows/row.h"
#include "command/variables.h"

namespace temblor::client {

// How a row shows a variable. Strings and spans must outlive the row.
struct OptionLook {
  std::string_view variable, label;
  // Range and step of the slider; low == high: the variable's own range, in 20 steps.
  double low = 0, high = 0, step = 0;
  // The number shown is the value times this: 100 for percent.
  double shown_factor = 1;
  // Appended to the number, with a space if there is to be one.
  std::string_view unit = "";
  // Shown in place of the number 0.
  std::string_view zero = "";
  // Names of the values 0, 1, ..., or of the variable's choices in their order. A number with names is a
  // choice rather than a slider.
  std::span<const std::string_view> names = {};
};

// Makes the row for a variable. Changes take effect at once. Returns null if the variable is not registered.
std::unique_ptr<Row> make_option_row(command::Variables& io_variables, const OptionLook& look);

// Makes a row that chooses one of the 14 colors of players' clothes. Returns null if there is no whole-number
// variable of that name.
std::unique_ptr<Row> make_color_row(command::Variables& io_variables, const OptionLook& look);

}  // namespace temblor::client
