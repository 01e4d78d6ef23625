// Finds the completions of a console line, by its last command and the number of its words:
//
//   sen|                 first word:        commands, aliases, variables
//   map e|               of a command:      its argument list
//   set r_color f|       of a command, 2+:  values of the variable that is its first argument
//   r_color f|           of a variable:     its values
#include "command/completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "command/console.h"
#include "command/text.h"

namespace temblor::command {

namespace {

// Case-insensitive order; names that differ only in case have a fixed order.
bool comes_before(const Candidate& a, const Candidate& b) {
  const std::string lower_a = base::to_lower(a.name), lower_b = base::to_lower(b.name);
  return lower_a != lower_b ? lower_a < lower_b : a.name < b.name;
}

bool starts_with(std::string_view text, std::string_view prefix) {
  return base::equal_ignoring_case(text.substr(0, prefix.size()), prefix);
}

// Lists the values of a variable that has only a few; empty for numbers and texts.
std::vector<Candidate> list_values(const Variable& variable) {
  std::vector<Candidate> values;
  if (variable.type == VariableType::kBool)
    for (const char* value : {"0", "1"}) values.push_back({value, CandidateKind::kArgument, "", ""});
  for (const std::string& choice : variable.choices)
    values.push_back({choice, CandidateKind::kArgument, "", ""});
  return values;
}

std::string make_hint(const Variable& variable) {
  return fmt::format("{} is \"{}\": {} Takes {}; {} by default.", variable.name, variable.text, variable.help,
                     describe_values(variable), variable.default_text);
}

// Returns where the last command of a line starts.
std::size_t find_last_command(std::string_view line) {
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = begin + command_length(line.substr(begin));
    if (end >= line.size()) return begin;
    begin = end + 1;
  }
}

}  // namespace

std::vector<Candidate> Console::find_candidates(Kinds kinds, std::string_view prefix) const {
  std::vector<Candidate> found;
  if (kinds.commands)
    for (const auto& [name, command] : commands_)
      if (starts_with(name, prefix)) found.push_back({name, CandidateKind::kCommand, "", command.help});
  if (kinds.aliases)
    for (const auto& [name, alias] : aliases_)
      if (starts_with(name, prefix)) found.push_back({name, CandidateKind::kAlias, alias.text, ""});
  if (kinds.variables)
    for (const Variable* variable : variables_.all())
      if (starts_with(variable->name, prefix))
        found.push_back({variable->name, CandidateKind::kVariable, variable->text, variable->help});
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

std::vector<Candidate> Console::candidates(std::string_view prefix) const {
  return find_candidates({}, prefix);
}

std::vector<std::string> Console::complete(std::string_view prefix) const {
  std::vector<std::string> names;
  for (const Candidate& candidate : candidates(prefix)) names.push_back(candidate.name);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

Completion Console::complete_line(std::string_view line) const {
  const std::size_t command = find_last_command(line);
  const std::size_t gap = line.find_last_of(" \t\"");
  Completion completion;
  completion.begin = std::max(command, gap == std::string_view::npos ? 0 : gap + 1);
  // An opening quote alone is not a word yet.
  const bool is_quoted = completion.begin > command && line[completion.begin - 1] == '"';
  const std::size_t words_end = completion.begin - (is_quoted ? 1 : 0);
  const std::vector<std::string> words = split_words(line.substr(command, words_end - command));
  if (!words.empty()) {
    complete_argument(words, line.substr(completion.begin), completion);
    return completion;
  }
  completion.candidates = candidates(line.substr(completion.begin));
  return completion;
}

void Console::complete_argument(Arguments words, std::string_view prefix, Completion& io_completion) const {
  std::vector<Candidate>& found = io_completion.candidates;
  const auto command = commands_.find(base::to_lower(words[0]));
  const bool is_command = command != commands_.end();
  // "NAME VALUE", "set NAME VALUE", "cycle NAME VALUE VALUE ...".
  const bool takes_variable = !is_command || words.size() > 1;
  const Variable* const variable = takes_variable ? variables_.find(words[is_command ? 1 : 0]) : nullptr;
  if (is_command) io_completion.hint = command->second.help;
  if (is_command && words.size() == 1) {
    if (command->second.arguments != nullptr) found = command->second.arguments();
  } else if (variable != nullptr) {
    found = list_values(*variable);
    io_completion.hint = make_hint(*variable);
  }
  std::erase_if(found, [&](const Candidate& candidate) { return !starts_with(candidate.name, prefix); });
  std::sort(found.begin(), found.end(), comes_before);
}

}  // namespace temblor::command
