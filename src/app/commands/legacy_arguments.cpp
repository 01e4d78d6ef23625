#include "app/commands/legacy_arguments.h"

#include <algorithm>
#include <cctype>

#include "command/text.h"

namespace temblor::app {
namespace {

// Not "+0button", which is a texture.
bool begins_command(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
}

std::string with_two_dashes(std::string word) {
  return word == "-basedir" || word == "-game" ? "-" + word : word;
}

}  // namespace

std::vector<std::string> from_legacy_arguments(std::span<const char* const> words,
                                               std::span<const std::string> commands) {
  std::vector<std::string> all, ours;
  std::vector<std::vector<std::string>> to_execute;
  bool is_in_command = false;
  for (const char* const given : words) {
    const std::string& word = all.emplace_back(with_two_dashes(given));
    if (begins_command(word)) {
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
