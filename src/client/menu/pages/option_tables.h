// Which variables the pages of options show, and how: one table a page. What a program does not register is
// left out.
#pragma once

#include <span>
#include <string_view>

#include "client/menu/rows/option_rows.h"

namespace temblor::client {

std::span<const OptionLook> picture_options();  // of the video page
std::span<const OptionLook> screen_options();
std::span<const OptionLook> sound_options();
std::span<const OptionLook> control_options();
std::span<const OptionLook> accessibility_options();

// Actions that keys can be bound to, by what they are about. A heading has no commands.
struct BoundAction {
  std::string_view label, commands;
};
std::span<const BoundAction> bound_actions();

}  // namespace temblor::client
