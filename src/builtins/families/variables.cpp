// Built-in functions for console variables.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// Bounds what a program can register.
constexpr std::size_t kMaxVariables = 4096;
constexpr std::size_t kMaxVariableNameChars = 63;

// Letters, digits and underscores, so that the name can be typed at the console.
bool is_variable_name(std::string_view name) {
  const auto is_allowed = [](char c) {
    const char lower = base::to_lower(c);
    return (lower >= 'a' && lower <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.size() <= kMaxVariableNameChars &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

// cvar(name): the variable's number, or 0.
base::Status cvar(Call& io_call) {
  io_call.machine.return_float(io_call.variable(io_call.text(0)));
  return base::Ok{};
}

// cvar_string(name): the variable's text, or the empty string.
base::Status cvar_string(Call& io_call) {
  const command::Variable* const found = io_call.context.variables.find(io_call.text(0));
  return io_call.return_text(found == nullptr ? "" : found->text);
}

// cvar_set(name, value): an unknown variable or a bad value prints a warning, but does not end the game.
// Programs set the switches of other engines' physics, which are variables of their own from then on.
base::Status cvar_set(Call& io_call) {
  command::Variables& variables = io_call.context.variables;
  const std::string_view name = io_call.text(0);
  if (name.starts_with("sv_gameplayfix_") && is_variable_name(name) && variables.find(name) == nullptr &&
      variables.all().size() < kMaxVariables)
    variables.add_text(name, "0", "A switch of other engines' physics, which game code has set.");
  const base::Status set = variables.set(io_call.text(0), io_call.text(1));
  if (!set.ok()) io_call.warn_once(base::printable(set.error().message()));
  return base::Ok{};
}

base::Status cvar_setf(Call& io_call) {
  const base::Status set =
      io_call.context.variables.set(io_call.text(0), fmt::format("{}", io_call.number(1)));
  if (!set.ok()) io_call.warn_once(base::printable(set.error().message()));
  return base::Ok{};
}

// registercvar(name, value): returns 1 if the variable is new.
base::Status registercvar(Call& io_call) {
  const std::string_view name = io_call.text(0);
  if (!is_variable_name(name)) return io_call.error("\"{}\" is not a variable name", base::quotable(name));
  command::Variables& variables = io_call.context.variables;
  const bool is_new = variables.find(name) == nullptr;
  if (is_new) {
    if (variables.all().size() >= kMaxVariables)
      return io_call.error("there are {} variables already", kMaxVariables);
    variables.add_text(name, io_call.text(1), "A setting of the game's own.");
  }
  io_call.machine.return_float(is_new ? 1 : 0);
  return base::Ok{};
}

// cvar_defstring(name) and cvar_description(name): empty if there is no such variable.
base::Status cvar_defstring(Call& io_call) {
  const command::Variable* const found = io_call.context.variables.find(io_call.text(0));
  return io_call.return_text(found == nullptr ? "" : found->default_text);
}
base::Status cvar_description(Call& io_call) {
  const command::Variable* const found = io_call.context.variables.find(io_call.text(0));
  return io_call.return_text(found == nullptr ? "" : found->help);
}

// cvar_type(name): bits. 1: it exists, 2: it is saved, 8: it belongs to the engine, 16: it has a description.
base::Status cvar_type(Call& io_call) {
  constexpr int kExists = 1, kIsSaved = 2, kIsEngines = 8, kHasDescription = 16;
  const command::Variable* const found = io_call.context.variables.find(io_call.text(0));
  if (found == nullptr) return io_call.return_number(0);
  if (found->is_user_made) return io_call.return_number(kExists | (found->is_kept ? kIsSaved : 0));
  return io_call.return_number(kExists | kIsSaved | kIsEngines | kHasDescription);
}

}  // namespace

std::span<const Entry> variable_builtins() {
  static constexpr Entry kEntries[] = {
      {45, "cvar", cvar},
      {72, "cvar_set", cvar_set},
      {93, "registercvar", registercvar},
      {176, "cvar_setf", cvar_setf},
      {448, "cvar_string", cvar_string},
      {482, "cvar_defstring", cvar_defstring},
      {495, "cvar_type", cvar_type},
      {518, "cvar_description", cvar_description},
  };
  return kEntries;
}

}  // namespace temblor::builtins
