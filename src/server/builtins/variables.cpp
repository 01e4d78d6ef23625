// Built-in functions for console variables and commands.
#include <algorithm>

#include "base/text.h"
#include "server/builtins/families.h"

namespace temblor::server {
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
  const command::Variable* const found = io_call.game.variables.find(io_call.text(0));
  return io_call.return_text(found == nullptr ? "" : found->text);
}

// cvar_set(name, value): an unknown variable or a bad value prints a warning, but does not end the game.
// Programs set the switches of other engines' physics, which are variables of their own from then on.
base::Status cvar_set(Call& io_call) {
  command::Variables& variables = io_call.game.variables;
  const std::string_view name = io_call.text(0);
  if (name.starts_with("sv_gameplayfix_") && is_variable_name(name) && variables.find(name) == nullptr &&
      variables.all().size() < kMaxVariables)
    variables.add_text(name, "0", "A switch of other engines' physics, which game code has set.");
  const base::Status set = io_call.game.variables.set(io_call.text(0), io_call.text(1));
  if (!set.ok()) io_call.warn_once(base::printable(set.error().message()));
  return base::Ok{};
}

// registercvar(name, value): returns 1 if the variable is new.
base::Status registercvar(Call& io_call) {
  const std::string_view name = io_call.text(0);
  if (!is_variable_name(name)) return io_call.error("\"{}\" is not a variable name", base::quotable(name));
  command::Variables& variables = io_call.game.variables;
  const bool is_new = variables.find(name) == nullptr;
  if (is_new) {
    if (variables.all().size() >= kMaxVariables)
      return io_call.error("there are {} variables already", kMaxVariables);
    variables.add_text(name, io_call.text(1), "A setting of the game's own.");
  }
  io_call.machine.return_float(is_new ? 1 : 0);
  return base::Ok{};
}

// localcmd(text, ...): runs a console command of the host, after QuakeC has returned.
base::Status localcmd(Call& io_call) {
  std::string& commands = io_call.game.requests.commands;
  const std::string text = io_call.joined_text(0);
  if (text.size() > Requests::kMaxCommandBytes - std::min(commands.size(), Requests::kMaxCommandBytes))
    return io_call.error("more than {} bytes of commands are waiting", Requests::kMaxCommandBytes);
  commands += text;
  return base::Ok{};
}

// clientcommand(player, command): runs a player's command later, as if the game code had not seen it.
base::Status clientcommand(Call& io_call) {
  TRY(const vm::EntityIndex player, io_call.player(0));
  if (!io_call.game.client_command) return io_call.error("this server does not run players' commands");
  io_call.game.client_command(player, std::string(io_call.text(1)));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> variable_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {45, "cvar", cvar},
      {46, "localcmd", localcmd},
      {72, "cvar_set", cvar_set},
      {93, "registercvar", registercvar},
      {440, "clientcommand", clientcommand},
      {448, "cvar_string", cvar_string},
  };
  return kEntries;
}

}  // namespace temblor::server
