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

// Options of other engines.
struct StockOption {
  enum class Use { kNothing, kSetting, kSilence, kServer, kPort };
  enum class Value { kNone, kOptional, kNeeded };
  std::string_view name;
  Use use = Use::kNothing;  // kNothing: it has no meaning here
  Value value = Value::kNone;
  std::string_view assignment = "";  // kSetting: what `--set` sets, with the value after a "=" at the end
  std::string_view default_value = "";
};
using Use = StockOption::Use;
using Value = StockOption::Value;
constexpr StockOption kStockOptions[] = {{"-bpp", Use::kNothing, Value::kNeeded},
                                         {"-condebug"},
                                         {"-current"},
                                         {"-dedicated", Use::kServer, Value::kOptional},
                                         {"-fullscreen", Use::kSetting, Value::kNone, "vid_mode=fullscreen"},
                                         {"-heapsize", Use::kNothing, Value::kNeeded},
                                         {"-height", Use::kSetting, Value::kNeeded, "vid_height="},
                                         {"-listen", Use::kSetting, Value::kOptional, "maxplayers=", "8"},
                                         {"-mem", Use::kNothing, Value::kNeeded},
                                         {"-nocdaudio"},
                                         {"-noforcemaccel"},
                                         {"-noforcemparms"},
                                         {"-noforcemspd"},
                                         {"-noipx"},
                                         {"-nojoy"},
                                         {"-nomouse"},
                                         {"-nosound", Use::kSilence},
                                         {"-port", Use::kPort, Value::kNeeded},
                                         {"-udpport", Use::kPort, Value::kNeeded},
                                         {"-width", Use::kSetting, Value::kNeeded, "vid_width="},
                                         {"-window", Use::kSetting, Value::kNone, "vid_mode=window"},
                                         {"-zone", Use::kNothing, Value::kNeeded}};

// A translated line.
struct Line {
  std::vector<std::string> all;   // the words as they were given, in case that no translation applies
  std::vector<std::string> ours;  // without console commands
  std::vector<std::vector<std::string>> to_execute;
  std::vector<std::string> of_play, of_serve;
  std::string port;
  bool is_legacy = false, is_dedicated = false;
};

void apply_option(const StockOption& option, std::string value, Line& io_line) {
  if (value.empty()) value = option.default_value;
  switch (option.use) {
    case Use::kNothing:
      break;
    case Use::kSetting:
      io_line.ours.insert(io_line.ours.end(), {"--set", std::string(option.assignment) + value});
      break;
    case Use::kSilence:
      io_line.of_play.emplace_back("--nosound");
      break;
    case Use::kServer:
      io_line.is_dedicated = true;
      if (!value.empty()) io_line.of_serve.insert(io_line.of_serve.end(), {"--maxclients", value});
      break;
    case Use::kPort:
      io_line.of_play.insert(io_line.of_play.end(), {"--set", "port=" + value});
      io_line.of_serve.insert(io_line.of_serve.end(), {"--port", value});
      break;
  }
}

// Returns how many of the words an option of other engines takes; 0: it is none, or misses its value.
std::size_t translate_option(std::span<const char* const> words, Line& io_line) {
  const auto* const option =
      std::find_if(std::begin(kStockOptions), std::end(kStockOptions),
                   [&](const StockOption& candidate) { return candidate.name == words[0]; });
  if (option == std::end(kStockOptions)) return 0;
  const bool has_value =
      option->value != Value::kNone && words.size() > 1 && command::parse_whole_number(words[1]).has_value();
  if (option->value == Value::kNeeded && !has_value) return 0;
  const std::size_t taken = has_value ? 2 : 1;
  io_line.all.insert(io_line.all.end(), words.begin(), words.begin() + static_cast<std::ptrdiff_t>(taken));
  io_line.is_legacy = true;
  apply_option(*option, has_value ? words[1] : "", io_line);
  return taken;
}

// A stock server begins with the level of +map, or else with "start".
void choose_first_level(Line& io_line) {
  const auto map = std::find_if(io_line.to_execute.begin(), io_line.to_execute.end(),
                                [](const auto& words) { return words.size() == 2 && words[0] == "map"; });
  const bool is_given = map != io_line.to_execute.end();
  io_line.of_serve.insert(io_line.of_serve.end(), {"--map", is_given ? (*map)[1] : "start"});
  if (is_given) io_line.to_execute.erase(map);
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
  // A mission pack's folder comes first, wherever its option is, because mods build on it.
  Line line;
  line.all = line.ours = list_packs(words);
  bool is_in_command = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view given = words[i];
    if (is_in_command && !given.starts_with('-') && !is_console_command(given)) {
      line.to_execute.back().emplace_back(line.all.emplace_back(given));
      continue;
    }
    is_in_command = is_console_command(given);
    if (is_in_command) {
      line.to_execute.push_back({line.all.emplace_back(given).substr(1)});
    } else if (const std::size_t taken = translate_option(words.subspan(i), line); taken > 0) {
      i += taken - 1;
    } else if (!assets::find_pack_folder(given)) {
      line.ours.push_back(line.all.emplace_back(use_two_dashes(std::string(given))));
      line.is_legacy = line.is_legacy || line.all.back() != given;
    }
  }
  if (line.to_execute.empty() && !line.is_legacy) return line.all;

  // Add `play` or `serve` if no command was given. Other commands have no console.
  std::vector<std::string>& ours = line.ours;
  const auto named = std::find_first_of(ours.begin(), ours.end(), commands.begin(), commands.end());
  const bool is_given = named != ours.end();
  if (!is_given && line.is_dedicated) choose_first_level(line);
  const std::string chosen = is_given ? *named : line.is_dedicated ? "serve" : "play";
  if (chosen != "play" && chosen != "serve") return line.all;
  if (!is_given) ours.push_back(chosen);
  const std::vector<std::string>& options = chosen == "play" ? line.of_play : line.of_serve;
  ours.insert(ours.end(), options.begin(), options.end());
  for (const std::vector<std::string>& words_of_command : line.to_execute) {
    ours.emplace_back("--exec");
    ours.push_back(command::join_words(words_of_command));
  }
  return ours;
}

}  // namespace temblor::app
