// What a line being typed could go on with.
#include "command/completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "command/console.h"
#include "command/text.h"

namespace temblor::command {

namespace {

// Without regard to case; names that differ only in case stay in one order.
bool comes_before(const Candidate& a, const Candidate& b) {
  const std::string lower_a = base::to_lower(a.name), lower_b = base::to_lower(b.name);
  return lower_a != lower_b ? lower_a < lower_b : a.name < b.name;
}

bool starts_with(std::string_view text, std::string_view prefix) {
  return base::equal_ignoring_case(text.substr(0, prefix.size()), prefix);
}

std::vector<Candidate> values_of(const Variable& variable) {
  std::vector<Candidate> values;
  if (variable.type == VariableType::kBool)
    for (const char* value : {"0", "1"}) values.push_back({value, CandidateKind::kArgument, "", ""});
  for (const std::string& choice : variable.choices)
    values.push_back({choice, CandidateKind::kArgument, "", ""});
  return values;
}

std::string hint_of(const Variable& variable) {
  return fmt::format("{} is \"{}\": {} Takes {}; {} by default.", variable.name, variable.text, variable.help,
                     describe_values(variable), variable.default_text);
}

// The last command of a line, and where it begins.
std::size_t last_command(std::string_view line) {
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = begin + command_length(line.substr(begin));
    if (end >= line.size()) return begin;
    begin = end + 1;
  }
}

}  // namespace

std::vector<Candidate> Console::candidates_of(Kinds kinds, std::string_view prefix) const {
  std::vector<Candidate> found;
  if (kinds.commands)
    for (const auto& [name, command] : commands_)
      if (starts_with(name, prefix)) found.push_back({name, CandidateKind::kCommand, "", command.help});
  if (kinds.aliases)
    for (const auto& [name, text] : aliases_)
      if (starts_with(name, prefix)) found.push_back({name, CandidateKind::kAlias, text, ""});
  if (kinds.variables)
    for (const Variable* variable : variables_.all())
      if (starts_with(variable->name, prefix))
        found.push_back({variable->name, CandidateKind::kVariable, variable->text, variable->help});
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

std::vector<Candidate> Console::candidates(std::string_view prefix) const {
  return candidates_of({}, prefix);
}

std::vector<std::string> Console::complete(std::string_view prefix) const {
  std::vector<std::string> names;
  for (const Candidate& candidate : candidates(prefix)) names.push_back(candidate.name);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

Completion Console::complete_line(std::string_view line) const {
  const std::size_t command = last_command(line);
  const std::size_t gap = line.find_last_of(" \t\"");
  Completion completion;
  completion.begin = std::max(command, gap == std::string_view::npos ? 0 : gap + 1);
  // A quote that has just been opened is no word yet.
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
    found = values_of(*variable);
    io_completion.hint = hint_of(*variable);
  }
  std::erase_if(found, [&](const Candidate& candidate) { return !starts_with(candidate.name, prefix); });
  std::sort(found.begin(), found.end(), comes_before);
}

}  // namespace temblor::command
