#include "app/commands/legacy_arguments.h"

#include <algorithm>
#include <cctype>

#include "command/text.h"

namespace temblor::app {
namespace {

// "+skill" is a console command, but "+0button" is the name of an animated texture.
bool is_console_command(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
}

// Only the two options that launchers pass; other single-dash words stay, so that -o works.
std::string use_two_dashes(std::string word) {
  return word == "-basedir" || word == "-game" ? "-" + word : word;
}

}  // namespace

std::vector<std::string> convert_legacy_arguments(std::span<const char* const> words,
                                                  std::span<const std::string> commands) {
  // `all` are the words as they were given, in case that no translation applies; `ours` are those without
  // console commands.
  std::vector<std::string> all, ours;
  std::vector<std::vector<std::string>> to_execute;
  bool is_in_command = false;
  for (const char* const given : words) {
    const std::string& word = all.emplace_back(use_two_dashes(given));
    if (is_console_command(word)) {
      to_execute.push_back({word.substr(1)});
      is_in_command = true;
    } else if (is_in_command && !word.starts_with('-')) {
      to_execute.back().push_back(word);
    } else {
      ours.push_back(word);
      is_in_command = false;
    }
  }
  if (to_execute.empty()) return all;

  // Add `play` if no command was given. Other commands than play and serve have no console.
  const auto named = std::find_first_of(ours.begin(), ours.end(), commands.begin(), commands.end());
  if (named == ours.end())
    ours.push_back("play");
  else if (*named != "play" && *named != "serve")
    return all;
  for (const std::vector<std::string>& command : to_execute) {
    ours.push_back("--exec");
    ours.push_back(command::join_words(command));
  }
  return ours;
}

}  // namespace temblor::app
