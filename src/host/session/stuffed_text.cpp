#include "host/session/stuffed_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/text.h"
#include "command/text.h"
#include "host/frame/host_parts.h"

namespace temblor::host {
namespace {

constexpr auto kSafeCommands = std::to_array<std::string_view>(
    {"bf", "cd", "centerview", "color", "echo", "fog", "force_centerview", "impulse", "music", "music_pause",
     "music_resume", "music_stop", "play", "playvol", "sky", "stopsound", "v_cshift"});
constexpr auto kSafeVariables = std::to_array<std::string_view>(
    {"bottomcolor", "crosshair", "fov", "r_drawviewmodel", "r_fog", "r_lavaalpha", "r_slimealpha",
     "r_telealpha", "r_wateralpha", "sensitivity", "topcolor", "v_idlescale", "viewsize"});

bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Commands that keys and aliases may run, too.
bool is_safe_to_bind(std::string_view name, const command::Aliases& aliases) {
  const auto alias = aliases.find(name);
  return contains(kSafeCommands, name) || contains(kSafeVariables, name) || name.starts_with('+') ||
         name.starts_with('-') ||
         (alias != aliases.end() && alias->second.source == command::Source::kServer);
}

bool is_text_safe_to_bind(std::string_view text, const command::Aliases& aliases) {
  for (const std::string_view command : command::split_commands(text)) {
    const std::vector<std::string> words = command::split_words(command);
    if (!words.empty() && !is_safe_to_bind(base::to_lower(words[0]), aliases)) return false;
  }
  return true;
}

bool is_safe(command::Console::Arguments words, const command::Aliases& aliases) {
  const std::string name = base::to_lower(words[0]);
  if (is_safe_to_bind(name, aliases)) return true;
  if ((name != "alias" && name != "bind") || words.size() < 3) return false;
  const std::string text =
      words.size() == 3 ? words[2] : command::join_words({words.begin() + 2, words.end()});
  return is_text_safe_to_bind(text, aliases);
}

bool is_known(const Host& host, const std::string& name) {
  const std::vector<std::string> known = host.console.commands.complete(name);
  return std::find(known.begin(), known.end(), name) != known.end();
}

command::Alias find_alias(const command::Aliases& aliases, const std::string& name) {
  const auto found = aliases.find(name);
  return found != aliases.end() ? found->second : command::Alias();
}

}  // namespace

bool may_be_stuffed(std::string_view line, const command::Aliases& aliases) {
  bool has_command = false;
  for (const std::string_view command : command::split_commands(line)) {
    const std::vector<std::string> words = command::split_words(command);
    if (words.empty()) continue;
    has_command = true;
    if (!is_safe(words, aliases)) return false;
  }
  return has_command;
}

// A later change of the server keeps the player's value, unless the player has set another one in between.
template <typename Key, typename Value>
void StuffedText::note_change(Changes<Key, Value>& io_changes, const Key& key, const Value& before,
                              const Value& after) {
  if (before == after) return;
  const auto [found, is_new] = io_changes.try_emplace(key, Change<Value>{before, after});
  if (is_new) return;
  Change<Value>& change = found->second;
  if (change.sent != before) change.own = before;
  change.sent = after;
  if (change.own == after) io_changes.erase(found);
}

StuffedText::Settings StuffedText::copy_settings(const Host& host) {
  const command::Variables& variables = host.variables.variables();
  Settings settings{.aliases = host.console.commands.aliases(), .bindings = host.input.bindings};
  for (std::size_t index = 0; index < variables.size(); ++index)
    settings.variables.push_back(variables.value(base::to_index<command::VariableIndex>(index)));
  return settings;
}

// In a game on this machine, the rules that game code sets stay: they belong to the player's next game.
void StuffedText::note_variables(const Host& host, const std::vector<command::VariableValue>& after) {
  const command::Variables& variables = host.variables.variables();
  for (std::size_t index = 0; index < after.size(); ++index) {
    const std::string& name = variables.get(base::to_index<command::VariableIndex>(index)).name;
    if (is_trusted_ && !contains(kSafeVariables, name)) continue;
    const bool was_made = index >= before_->variables.size();
    note_change(variables_, index, was_made ? command::VariableValue() : before_->variables[index],
                after[index]);
  }
}

void StuffedText::note_changes(const Host& host) {
  if (!before_) return;
  Settings after = copy_settings(host);
  note_variables(host, after.variables);
  for (const auto& [name, alias] : before_->aliases)
    note_change(aliases_, name, alias, find_alias(after.aliases, name));
  for (const auto& [name, alias] : after.aliases)
    note_change(aliases_, name, find_alias(before_->aliases, name), alias);
  for (std::size_t i = 0; i < platform::kKeys; ++i) {
    const auto key = static_cast<platform::Key>(i);
    note_change(keys_, key, before_->bindings.commands(key), after.bindings.commands(key));
  }
  before_ = std::move(after);
}

// Names of other engines' commands would do nothing here anyway.
void StuffedText::refuse(Host& io_host, const std::string& name) {
  if (is_known(io_host, name) && refused_.insert(name).second)
    print_line(io_host,
               fmt::format("The server's command \"{}\" was refused (cl_stufftext).", base::quotable(name)));
}

bool StuffedText::may_run(Host& io_host, command::Console::Arguments words) {
  const std::string name = base::to_lower(words[0]);
  const StuffedTextRule rule = is_trusted_ ? StuffedTextRule::kAll : io_host.variables.stuffed_text();
  if (rule == StuffedTextRule::kNone ||
      (rule == StuffedTextRule::kSafe && !is_safe(words, io_host.console.commands.aliases()))) {
    refuse(io_host, name);
    return false;
  }
  // A key passes its number, and releases the button itself.
  if (name.starts_with('+') && words.size() == 1) held_.insert(name.substr(1));
  if (name.starts_with('-')) held_.erase(name.substr(1));
  if (!before_) before_ = copy_settings(io_host);
  return true;
}

void StuffedText::add_rules(Host& io_host) {
  io_host.console.commands.set_server_rules({.may_run =
                                                 [&io_host](command::Console::Arguments words) {
                                                   return io_host.stuffed_text.may_run(io_host, words);
                                                 },
                                             .finish =
                                                 [&io_host] {
                                                   io_host.stuffed_text.note_changes(io_host);
                                                   io_host.stuffed_text.before_.reset();
                                                 }});
}

void StuffedText::run(Host& io_host, std::string_view line, bool is_trusted) {
  is_trusted_ = is_trusted;
  io_host.console.commands.append(line, command::Source::kServer);
}

bool StuffedText::has_bound(const client::Bindings& bindings, platform::Key key) const {
  const auto change = keys_.find(key);
  return change != keys_.end() && change->second.sent == bindings.commands(key);
}

void StuffedText::undo_variables(command::Variables& io_variables) const {
  for (const auto& [number, change] : variables_) {
    const auto index = base::to_index<command::VariableIndex>(number);
    if (io_variables.value(index) == change.sent) io_variables.put_back(index, change.own);
  }
}

void StuffedText::undo_bindings(client::Bindings& io_bindings) const {
  for (const auto& [key, change] : keys_)
    if (io_bindings.commands(key) == change.sent) io_bindings.bind(key, change.own);
}

StuffedText::OwnSettings StuffedText::own_settings(const Host& host) {
  note_changes(host);
  OwnSettings own{host.variables.variables(), host.input.bindings};
  undo_variables(own.variables);
  undo_bindings(own.bindings);
  return own;
}

void StuffedText::restore(Host& io_host) {
  note_changes(io_host);
  // It could change settings later, when nobody undoes that. A game on this machine may go on to another one.
  if (!is_trusted_) io_host.console.commands.drop_server_text();
  refused_.clear();
  io_host.video.server_tint = {};
  for (std::size_t i = 0; i < client::kButtons; ++i)
    if (const auto button = static_cast<client::Button>(i); held_.contains(client::button_name(button).name))
      io_host.input.player.buttons()[button].release(0, io_host.timing.now_s);
  held_.clear();
  undo_variables(io_host.variables.variables());
  undo_bindings(io_host.input.bindings);
  for (const auto& [name, change] : aliases_)
    if (find_alias(io_host.console.commands.aliases(), name) == change.sent)
      io_host.console.commands.set_alias(name, change.own);
  variables_.clear();
  aliases_.clear();
  keys_.clear();
  if (before_) before_ = copy_settings(io_host);
}

}  // namespace temblor::host
