#include "host/session/stuffed_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "base/text.h"
#include "client/input/key_names.h"
#include "command/text.h"
#include "host/frame/host_parts.h"

namespace temblor::host {
namespace {

constexpr auto kSafeCommands = std::to_array<std::string_view>(
    {"bf", "cd", "centerview", "fog", "force_centerview", "impulse", "music", "music_pause", "music_resume",
     "music_stop", "play", "playvol", "sky", "stopsound", "v_cshift"});
constexpr auto kSafeVariables = std::to_array<std::string_view>(
    {"fov", "r_wateralpha", "r_slimealpha", "r_lavaalpha", "r_telealpha", "r_fog"});

bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Commands that keys and aliases may run: the safe ones, and those that hold a button.
bool is_safe_to_bind(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = command::command_length(text);
    const std::vector<std::string> words = command::split_words(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    if (words.empty()) continue;
    const std::string name = base::to_lower(words[0]);
    if (!contains(kSafeCommands, name) && !name.starts_with('+') && !name.starts_with('-')) return false;
  }
  return true;
}

}  // namespace

// The line must be a single command: any text after a ';' would run as well.
bool may_be_stuffed(std::string_view line) {
  const std::vector<std::string> words = command::split_words(line);
  if (words.empty() || command::command_length(line) != line.size()) return false;
  const std::string name = base::to_lower(words[0]);
  if (contains(kSafeCommands, name) || contains(kSafeVariables, name)) return true;
  if (name != "alias" && name != "bind") return false;
  if (words.size() < 3) return false;
  const std::string text =
      words.size() == 3 ? words[2] : command::join_words({words.begin() + 2, words.end()});
  return is_safe_to_bind(text);
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

void StuffedText::run(Host& io_host, std::string_view line, bool is_trusted) {
  const std::vector<std::string> words = command::split_words(line);
  if (words.empty()) return;
  const std::string name = base::to_lower(words[0]);
  const StuffedTextRule rule = is_trusted ? StuffedTextRule::kAll : io_host.variables.stuffed_text();
  if (rule == StuffedTextRule::kNone || (rule == StuffedTextRule::kSafe && !may_be_stuffed(line))) {
    // Names of other engines' commands would do nothing here anyway.
    const std::vector<std::string> known = io_host.console.commands.complete(name);
    if (std::find(known.begin(), known.end(), name) != known.end() && refused_.insert(name).second)
      print_line(io_host, fmt::format("The server's command \"{}\" was refused (cl_stufftext).",
                                      base::quotable(name)));
    return;
  }
  // In a game on this machine, the rules that game code sets stay: they belong to the player's next game.
  const bool restores = !is_trusted || contains(kSafeVariables, name);
  std::optional<Change> change;
  if (command::command_length(line) != line.size()) return io_host.console.commands.append(line);
  if (words.size() > 1 && restores && io_host.variables.variables().find(name) != nullptr)
    change = Change{Kind::kVariable, name, {}, {}};
  else if (words.size() > 2 && name == "alias")
    change = Change{Kind::kAlias, base::to_lower(words[1]), {}, {}};
  else if (words.size() > 2 && name == "bind" && client::find_key(words[1]))
    change = Change{Kind::kKey, words[1], {}, {}};
  if (!change) return io_host.console.commands.append(line);
  const auto known = std::find_if(changes_.begin(), changes_.end(), [&](const Change& other) {
    return other.kind == change->kind && base::equal_ignoring_case(other.name, change->name);
  });
  // These run at once, so that the result can be read.
  if (known == changes_.end()) change->own = read(io_host, change->kind, change->name);
  io_host.console.commands.execute(line);
  Change& kept = known == changes_.end() ? changes_.emplace_back(std::move(*change)) : *known;
  kept.sent = read(io_host, kept.kind, kept.name);
}

// The latest change is undone first.
void StuffedText::restore(Host& io_host) {
  refused_.clear();
  io_host.video.server_tint = {};
  for (; !changes_.empty(); changes_.pop_back()) {
    const Change& change = changes_.back();
    if (read(io_host, change.kind, change.name) == change.sent) write(io_host, change);
  }
}

}  // namespace temblor::host
