#include "server/builtins/call.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/text.h"
#include "server/builtins/text/text_to_number.h"

namespace temblor::server {

base::Result<vm::EntityIndex> Call::entity(int i) const {
  const base::Result<vm::EntityIndex> value = machine.parameter_entity(i);
  if (!value.ok()) return error("parameter {} is not an entity", i + 1);
  return *value;
}

base::Result<vm::EntityIndex> Call::player(int i) const {
  TRY(const vm::EntityIndex value, entity(i));
  if (!is_player(value))
    return error("parameter {} is entity {}, which is not a player", i + 1, base::to_size(value));
  return value;
}

base::Result<vm::FieldIndex> Call::field(int i) const {
  const base::Result<vm::FieldIndex> value = machine.parameter_field(i);
  if (!value.ok()) return error("parameter {} is not a field", i + 1);
  return *value;
}

std::string Call::joined_text(int first) const {
  std::string joined;
  for (int i = first; i < machine.parameter_count(); ++i) joined += text(i);
  return joined;
}

std::vector<std::string> Call::localized_texts(int first) const {
  const formats::Localization none;
  const formats::Localization& known = game.localization == nullptr ? none : *game.localization;
  std::vector<std::string> texts;
  for (int i = first; i < machine.parameter_count(); ++i) texts.push_back(known.localize(text(i)));
  return texts;
}

std::string Call::localized_text(int first) const {
  const bool is_key = first < machine.parameter_count() && game.localization != nullptr &&
                      game.localization->has_text_for(text(first));
  const std::vector<std::string> texts = localized_texts(first);
  if (is_key && texts[0].find('{') != std::string::npos)
    return formats::fill_places(texts[0], std::span(texts).subspan(1));
  return fmt::format("{}", fmt::join(texts, ""));
}

// Text variables count, too, because registercvar() makes all of a program's variables text.
float Call::variable(std::string_view variable_name) const {
  const command::Variable* found = game.variables.find(variable_name);
  if (found == nullptr) return 0;
  const bool is_text = found->type == command::VariableType::kText;
  return is_text ? number_from(found->text) : static_cast<float>(found->number);
}

// The search is linear: levels have at most a few hundred sounds, most of them found early.
std::optional<std::uint16_t> Call::sound_number(std::string_view sample) const {
  const std::vector<std::string>& sounds = game.precache.sounds;
  const auto found = std::find(sounds.begin() + 1, sounds.end(), sample);
  if (found != sounds.end()) return static_cast<std::uint16_t>(found - sounds.begin());
  warn_once(fmt::format("\"{}\" was not precached", base::quotable(sample)));
  return std::nullopt;
}

// The built-in function itself is on the trace with statement 0.
std::string Call::call_site() const {
  const std::vector<vm::TraceEntry> trace = machine.current_trace();
  const auto caller = std::find_if(trace.begin(), trace.end(),
                                   [](const vm::TraceEntry& entry) { return entry.statement != 0; });
  if (caller == trace.end()) return "";
  return fmt::format(", in {}", machine.program().describe_place(caller->function, caller->statement));
}

void Call::warn_once(const std::string& text) const {
  // Bounds the memory for programs whose warnings differ each time.
  constexpr std::size_t kMaxWarnings = 256;
  if (game.warned.size() < kMaxWarnings && game.warned.insert(text).second)
    print(fmt::format("builtin {}: {}\n", name_, text));
}

base::Status Call::return_text(std::string_view text) const {
  TRY(const vm::StringIndex string, machine.make_string(text));
  machine.return_string(string);
  return base::Ok{};
}

}  // namespace temblor::server
