#include "app/stock_tools/stock_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/commands/compile_command.h"
#include "app/compile/level_output.h"
#include "app/files/diagnostics.h"
#include "app/stock_tools/stock_flags.h"
#include "app/stock_tools/world_key_flags.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

base::Error usage(const char* tool, std::string what) {
  return base::Error{base::ErrorCode::kUsage, fmt::format("{}: {}", tool, what), {}};
}

std::optional<StockTool> find_tool(std::string_view name) {
  for (const StockTool tool : {StockTool::kQbsp, StockTool::kVis, StockTool::kLight})
    if (name == tool_name(tool)) return tool;
  return std::nullopt;
}

// Reads the words of one command line, from the first to the last.
class StockParser {
 public:
  StockParser(StockCommand command, std::vector<std::string> words)
      : command_(std::move(command)), words_(std::move(words)) {}

  base::Result<StockCommand> parse() {
    while (at_ < words_.size()) {
      const std::string& word = words_[at_++];
      if (word.size() > 1 && word.starts_with('-'))
        TRY_STATUS(read_flag(word));
      else
        files_.push_back(word);
    }
    if (!command_.wants_help) TRY_STATUS(set_files());
    return std::move(command_);
  }

 private:
  const char* tool() const { return tool_name(command_.tool); }

  base::Status read_flag(const std::string& word) {
    const std::string name = base::to_lower(std::string_view(word).substr(word.starts_with("--") ? 2 : 1));
    for (const auto flags : {list_tool_flags(command_.tool), list_common_flags()})
      for (const StockFlag& flag : flags)
        if (flag.name == name) return apply(flag);
    if (command_.tool == StockTool::kLight)
      for (const WorldKeyFlag& flag : list_world_key_flags())
        if (flag.flag == name) return set_world_key(flag);
    return usage(tool(), describe_unknown_flag(name));
  }

  base::Status apply(const StockFlag& flag) {
    TRY(const std::vector<std::string> values, take_values(flag.name, flag.values));
    if (flag.is_refused) return usage(tool(), fmt::format("-{} is not supported: {}", flag.name, flag.note));
    if (flag.apply != nullptr)
      flag.apply(values, command_);
    else if (flag.note != nullptr)
      command_.notes.push_back(fmt::format("-{} has no effect: {}", flag.name, flag.note));
    return base::Ok{};
  }

  base::Status set_world_key(const WorldKeyFlag& flag) {
    const FlagValues wanted = flag.is_triple ? FlagValues::kThreeNumbers : FlagValues::kOptionalNumber;
    TRY(const std::vector<std::string> values, take_values(flag.flag, wanted));
    std::string value = values[0];
    for (std::size_t i = 1; i < values.size(); ++i) value += " " + values[i];
    command_.options.light_keys.emplace_back(flag.key, std::move(value));
    return base::Ok{};
  }

  base::Result<std::vector<std::string>> take_values(std::string_view flag, FlagValues wanted) {
    std::vector<std::string> values;
    const auto next_is_number = [&] { return at_ < words_.size() && parse_flag_number(words_[at_]); };
    if (wanted == FlagValues::kNone) return values;
    if (wanted == FlagValues::kText) {
      if (at_ == words_.size()) return usage(tool(), fmt::format("-{} needs a value", flag));
      values.push_back(words_[at_++]);
      return values;
    }
    if (wanted == FlagValues::kOptionalNumber && !next_is_number()) return std::vector<std::string>{"1"};
    for (int count = wanted == FlagValues::kThreeNumbers ? 3 : 1; count > 0; --count) {
      if (!next_is_number())
        return usage(tool(), fmt::format("-{} needs {}", flag,
                                         wanted == FlagValues::kThreeNumbers ? "three numbers" : "a number"));
      values.push_back(words_[at_++]);
    }
    return values;
  }

  std::string describe_unknown_flag(const std::string& name) const {
    std::vector<std::string_view> names;
    for (const auto flags : {list_tool_flags(command_.tool), list_common_flags()})
      for (const StockFlag& flag : flags) names.emplace_back(flag.name);
    if (command_.tool == StockTool::kLight)
      for (const WorldKeyFlag& flag : list_world_key_flags()) names.push_back(flag.flag);
    const auto nearest = base::find_nearest_name(name, names);
    return fmt::format("unknown flag -{}; {}", base::quotable(name),
                       nearest ? fmt::format("did you mean -{}?", *nearest)
                               : fmt::format("`temblor {} -help` lists all flags", tool()));
  }

  // Completes the names of files as the stock tools do.
  base::Status set_files() {
    const bool is_qbsp = command_.tool == StockTool::kQbsp;
    if (files_.empty()) return usage(tool(), is_qbsp ? "no map given" : "no level given");
    if (files_.size() > (is_qbsp ? 2u : 1u))
      return usage(tool(), fmt::format("unexpected file {}", base::quotable(files_.back())));
    CompileCommandOptions& options = command_.options;
    fs::path source = files_[0];
    if (!source.has_extension()) source += is_qbsp ? ".map" : ".bsp";
    if (!is_qbsp) source.replace_extension(".bsp");
    options.source = source.string();
    // Only the first stage reads textures.
    if (!is_qbsp) options.wads.clear();
    if (files_.size() == 2) options.out = fs::path(files_[1]).replace_extension(".bsp").string();
    return base::Ok{};
  }

  StockCommand command_;
  std::vector<std::string> words_, files_;
  std::size_t at_ = 0;
};

// The options that make a stage of `temblor compile` the stock tool.
StockCommand make_command(StockTool tool) {
  constexpr CompileStage kStages[] = {CompileStage::kBsp, CompileStage::kVisibility, CompileStage::kLight};
  StockCommand command;
  command.tool = tool;
  command.options.only = kStages[static_cast<std::size_t>(tool)];
  command.options.wad_option = "-wadpath";
  command.options.portals = tool == StockTool::kQbsp;
  command.options.keeps_portals = tool != StockTool::kQbsp;
  return command;
}

void print_flags(StockTool tool) {
  fmt::print("temblor {} {}\n\nFlags, as in ericw-tools (docs/ericw-tools.md):\n", tool_name(tool),
             tool == StockTool::kQbsp ? "[FLAG]... FILE.map [FILE.bsp]" : "[FLAG]... FILE.bsp");
  std::string line = " ";
  const auto add = [&](std::string_view name) {
    constexpr std::size_t kWidth = 100;
    if (line.size() + name.size() + 2 > kWidth) {
      fmt::print("{}\n", line);
      line = " ";
    }
    line += fmt::format(" -{}", name);
  };
  for (const auto flags : {list_tool_flags(tool), list_common_flags()})
    for (const StockFlag& flag : flags)
      if (!flag.is_refused) add(flag.name);
  if (tool == StockTool::kLight)
    for (const WorldKeyFlag& flag : list_world_key_flags()) add(flag.flag);
  fmt::print("{}\n", line);
}

}  // namespace

const char* tool_name(StockTool tool) {
  switch (tool) {
    case StockTool::kQbsp:
      return "qbsp";
    case StockTool::kVis:
      return "vis";
    case StockTool::kLight:
      return "light";
  }
  return "";
}

base::Result<std::optional<StockCommand>> parse_stock_command(std::string_view program,
                                                              std::span<const char* const> words) {
  std::optional<StockTool> tool = find_tool(fs::path(program).stem().string());
  GameFolders folders;
  std::size_t at = 0;
  while (!tool && at < words.size()) {
    const std::string_view word = words[at++];
    const bool is_base = word == "--basedir" || word == "-basedir",
               is_game = word == "--game" || word == "-game";
    if ((is_base || is_game) && at < words.size()) {
      if (is_base)
        folders.base_folder = words[at++];
      else
        folders.games.emplace_back(words[at++]);
    } else if (!(tool = find_tool(word))) {
      return std::optional<StockCommand>();
    }
  }
  if (!tool) return std::optional<StockCommand>();
  StockCommand command = make_command(*tool);
  command.folders = std::move(folders);
  TRY(command, StockParser(std::move(command), {words.begin() + static_cast<std::ptrdiff_t>(at), words.end()})
                   .parse());
  return std::optional(std::move(command));
}

base::Status run_stock_command(const StockCommand& command) {
  if (command.wants_help) {
    print_flags(command.tool);
    return base::Ok{};
  }
  for (const std::string& note : command.notes) print_note(note);
  const LevelPaths paths = make_level_paths(command.options.source);
  std::error_code failure;
  if (command.tool == StockTool::kVis && fs::exists(paths.points, failure)) {
    print_note(fmt::format("{}: the level leaks, so it gets no visibility; {} shows where",
                           command.options.source, paths.points.string()));
    return base::Ok{};
  }
  return run_compile(command.options, command.folders);
}

}  // namespace temblor::app
