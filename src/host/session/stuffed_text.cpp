#include "host/session/stuffed_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/text.h"
#include "client/input/key_names.h"
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

std::vector<std::string_view> split_commands(std::string_view line) {
  std::vector<std::string_view> commands;
  while (!line.empty()) {
    const std::size_t length = command::command_length(line);
    commands.push_back(line.substr(0, length));
    line.remove_prefix(std::min(length + 1, line.size()));
  }
  return commands;
}

bool is_button(std::string_view name) {
  return name.starts_with('+') || name.starts_with('-');
}

// Commands that keys and aliases may run, too: they change nothing that would have to be restored.
bool is_safe_to_bind(std::string_view name, const AliasNames& own_aliases) {
  return name != "color" && (contains(kSafeCommands, name) || is_button(name) || own_aliases.contains(name));
}

bool is_text_safe_to_bind(std::string_view text, const AliasNames& own_aliases) {
  for (const std::string_view command : split_commands(text)) {
    const std::vector<std::string> words = command::split_words(command);
    if (!words.empty() && !is_safe_to_bind(base::to_lower(words[0]), own_aliases)) return false;
  }
  return true;
}

bool is_safe(const std::vector<std::string>& words, const AliasNames& own_aliases) {
  const std::string name = base::to_lower(words[0]);
  if (contains(kSafeVariables, name) || contains(kSafeCommands, name) || is_safe_to_bind(name, own_aliases))
    return true;
  if ((name != "alias" && name != "bind") || words.size() < 3) return false;
  const std::string text =
      words.size() == 3 ? words[2] : command::join_words({words.begin() + 2, words.end()});
  return is_text_safe_to_bind(text, own_aliases);
}

bool is_known(const Host& host, const std::string& name) {
  const std::vector<std::string> known = host.console.commands.complete(name);
  return std::find(known.begin(), known.end(), name) != known.end();
}

}  // namespace

bool may_be_stuffed(std::string_view line, const AliasNames& own_aliases) {
  bool has_command = false;
  for (const std::string_view command : split_commands(line)) {
    const std::vector<std::string> words = command::split_words(command);
    if (words.empty()) continue;
    has_command = true;
    if (!is_safe(words, own_aliases)) return false;
  }
  return has_command;
}

std::string StuffedText::read(const Host& host, Kind kind, const std::string& name) {
  switch (kind) {
    case Kind::kVariable:
      return host.variables.variables().find(name)->text;
    case Kind::kAlias: {
      const std::string* const text = host.console.commands.find_alias(name);
      return text != nullptr ? *text : std::string();
    }
    case Kind::kKey:
      return host.input.bindings.commands(*client::find_key(name));
  }
  return {};
}

void StuffedText::write(Host& io_host, const Change& change) {
  switch (change.kind) {
    case Kind::kVariable:
      print_if_error(io_host, io_host.variables.variables().set(change.name, change.own));
      break;
    case Kind::kAlias:
      io_host.console.commands.set_alias(change.name, change.own);
      break;
    case Kind::kKey:
      io_host.input.bindings.bind(*client::find_key(change.name), change.own);
      break;
  }
}

// In a game on this machine, the rules that game code sets stay: they belong to the player's next game.
std::vector<StuffedText::Change> StuffedText::find_changes(const Host& host,
                                                           const std::vector<std::string>& words,
                                                           bool is_trusted) {
  const std::string name = base::to_lower(words[0]);
  std::vector<Change> changes;
  const auto add = [&](Kind kind, std::string changed) {
    changes.push_back({kind, changed, read(host, kind, changed), {}});
  };
  if (words.size() > 1 && name == "color") {
    add(Kind::kVariable, "topcolor");
    add(Kind::kVariable, "bottomcolor");
  } else if (words.size() > 1 && (!is_trusted || contains(kSafeVariables, name)) &&
             host.variables.variables().find(name) != nullptr) {
    add(Kind::kVariable, name);
  } else if (words.size() > 2 && name == "alias") {
    add(Kind::kAlias, base::to_lower(words[1]));
  } else if (words.size() > 2 && name == "bind" && client::find_key(words[1])) {
    add(Kind::kKey, words[1]);
  }
  return changes;
}

AliasNames StuffedText::find_own_aliases(const Host& host) const {
  AliasNames names;
  for (const Change& change : changes_)
    if (change.kind == Kind::kAlias && read(host, change.kind, change.name) == change.sent)
      names.insert(change.name);
  return names;
}

// Names of other engines' commands would do nothing here anyway.
void StuffedText::refuse(Host& io_host, const std::string& name) {
  if (is_known(io_host, name) && refused_.insert(name).second)
    print_line(io_host,
               fmt::format("The server's command \"{}\" was refused (cl_stufftext).", base::quotable(name)));
}

void StuffedText::run_command(Host& io_host, std::string_view command, bool is_trusted) {
  const std::vector<std::string> words = command::split_words(command);
  if (words.empty()) return;
  const std::string name = base::to_lower(words[0]);
  const StuffedTextRule rule = is_trusted ? StuffedTextRule::kAll : io_host.variables.stuffed_text();
  if (rule == StuffedTextRule::kNone ||
      (rule == StuffedTextRule::kSafe && !is_safe(words, find_own_aliases(io_host))))
    return refuse(io_host, name);
  if (name.starts_with('+') && is_known(io_host, name)) held_.insert(name.substr(1));
  if (name.starts_with('-')) held_.erase(name.substr(1));
  std::vector<Change> changes = find_changes(io_host, words, is_trusted);
  if (changes.empty()) return io_host.console.commands.append(command);
  // These run at once, so that the result can be read.
  io_host.console.commands.execute(command);
  for (Change& change : changes) {
    const auto known = std::find_if(changes_.begin(), changes_.end(), [&](const Change& other) {
      return other.kind == change.kind && base::equal_ignoring_case(other.name, change.name);
    });
    Change& kept = known == changes_.end() ? changes_.emplace_back(std::move(change)) : *known;
    kept.sent = read(io_host, kept.kind, kept.name);
  }
}

void StuffedText::run(Host& io_host, std::string_view line, bool is_trusted) {
  const std::vector<std::string_view> commands = split_commands(line);
  // All commands of a server with every right run in their order, because `wait` may separate them.
  const bool runs_all = is_trusted || io_host.variables.stuffed_text() == StuffedTextRule::kAll;
  if (commands.size() > 1 && runs_all) return io_host.console.commands.append(line);
  for (const std::string_view command : commands) run_command(io_host, command, is_trusted);
}

// The latest change is undone first.
void StuffedText::restore(Host& io_host) {
  refused_.clear();
  io_host.video.server_tint = {};
  for (const std::string& button : std::exchange(held_, {})) io_host.console.commands.execute("-" + button);
  for (; !changes_.empty(); changes_.pop_back()) {
    const Change& change = changes_.back();
    if (read(io_host, change.kind, change.name) == change.sent) write(io_host, change);
  }
}

}  // namespace temblor::host
