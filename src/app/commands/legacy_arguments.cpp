#include "app/commands/legacy_arguments.h"

#include <algorithm>
#include <cctype>

#include "assets/mission_pack.h"
#include "command/text.h"

namespace temblor::app {
namespace {

// "+skill" is a console command, but "+0button" is the name of an animated texture.
bool is_console_command(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
}

// Options of the window. Each becomes `--set`, with the next word after a "=" at the end.
struct WindowOption {
  std::string_view name, assignment;
};
constexpr WindowOption kWindowOptions[] = {{"-fullscreen", "vid_mode=fullscreen"},
                                           {"-height", "vid_height="},
                                           {"-width", "vid_width="},
                                           {"-window", "vid_mode=window"}};

const WindowOption* find_window_option(std::string_view word) {
  const auto* const found = std::find_if(std::begin(kWindowOptions), std::end(kWindowOptions),
                                         [&](const WindowOption& option) { return option.name == word; });
  return found == std::end(kWindowOptions) ? nullptr : found;
}

// Only options that launchers pass; other single-dash words stay, so that -o works.
std::string use_two_dashes(std::string word) {
  return word == "-basedir" || word == "-game" ? "-" + word : word;
}

// Returns `--game FOLDER` for each option of a mission pack.
std::vector<std::string> list_packs(std::span<const char* const> words) {
  std::vector<std::string> options;
  for (const char* const word : words)
    if (const auto folder = assets::find_pack_folder(word))
      options.insert(options.end(), {"--game", std::string(*folder)});
  return options;
}

}  // namespace

std::vector<std::string> convert_legacy_arguments(std::span<const char* const> words,
                                                  std::span<const std::string> commands) {
  // `all` are the words as they were given, in case that no translation applies; `ours` are those without
  // console commands.
  // A mission pack's folder comes first, wherever its option is, because mods build on it.
  std::vector<std::string> all = list_packs(words), ours = all;
  std::vector<std::vector<std::string>> to_execute;
  std::vector<std::string> of_play;
  bool is_in_command = false, is_legacy = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view given = words[i];
    if (assets::find_pack_folder(given)) {
      is_in_command = false;
      continue;
    }
    const std::string& word = all.emplace_back(use_two_dashes(std::string(given)));
    is_legacy = is_legacy || word != given;
    if (is_console_command(word)) {
      to_execute.push_back({word.substr(1)});
      is_in_command = true;
      continue;
    }
    if (is_in_command && !word.starts_with('-')) {
      to_execute.back().push_back(word);
      continue;
    }
    is_in_command = false;
    const WindowOption* const option = find_window_option(word);
    const bool has_value = option != nullptr && option->assignment.ends_with('=');
    if (word == "-nosound") {
      of_play.push_back("--nosound");
    } else if (option != nullptr && (!has_value || i + 1 < words.size())) {
      ours.insert(ours.end(), {"--set", std::string(option->assignment)});
      if (has_value) ours.back() += all.emplace_back(words[++i]);
      is_legacy = true;
    } else {
      ours.push_back(word);
    }
  }
  if (to_execute.empty() && of_play.empty() && !is_legacy) return all;

  // Add `play` if no command was given. Other commands than play and serve have no console.
  const auto named = std::find_first_of(ours.begin(), ours.end(), commands.begin(), commands.end());
  if (named == ours.end())
    ours.push_back("play");
  else if (*named != "play" && *named != "serve")
    return all;
  ours.insert(ours.end(), of_play.begin(), of_play.end());
  for (const std::vector<std::string>& command : to_execute) {
    ours.push_back("--exec");
    ours.push_back(command::join_words(command));
  }
  return ours;
}

}  // namespace temblor::app
