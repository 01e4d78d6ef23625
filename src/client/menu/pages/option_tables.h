// Tables for the pages of settings: which variables a page shows and how. Rows of variables that the program
// does not register are left out. Help texts are those of the variables themselves.
#pragma once

#include <span>
#include <string_view>

#include "client/menu/rows/option_rows.h"

namespace temblor::client {

// Each page's rows, in order; picture_options() are on the video page. The tables live as long as the
// program.
std::span<const OptionLook> picture_options();
std::span<const OptionLook> screen_options();
std::span<const OptionLook> sound_options();
std::span<const OptionLook> control_options();
std::span<const OptionLook> accessibility_options();

// Actions that keys can be bound to, grouped under headings. A heading has no commands.
struct BoundAction {
  std::string_view label, commands;
};
std::span<const BoundAction> bound_actions();
// The action of a weapon that only the shipped game has.
constexpr std::string_view kTremorLabel = "Tremor";

}  // namespace temblor::client
