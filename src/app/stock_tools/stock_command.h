// The command lines of the stock map compilers qbsp, vis, and light, with the flags of ericw-tools' manual,
// so that build scripts and editors' compile profiles work with Temblor:
//
//   temblor qbsp -bsp2 -wadpath wads castle.map      writes castle.bsp, castle.prt or castle.pts
//   temblor vis -threads 4 castle.bsp                reads castle.prt if there is no castle.build
//   temblor light -extra4 -bounce castle.bsp         lights the level in place
//
// Each tool is one stage of `temblor compile` (app/compile). A program that is called qbsp, vis, or light,
// for example a link to Temblor, is that tool.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/options.h"
#include "app/compile/compile_options.h"
#include "base/result.h"

namespace temblor::app {

enum class StockTool : std::uint8_t { kQbsp, kVis, kLight };
const char* tool_name(StockTool tool);

// A command line of a stock tool, translated.
struct StockCommand {
  StockTool tool = StockTool::kQbsp;
  CompileCommandOptions options;
  GameFolders folders;
  bool wants_help = false;
  std::vector<std::string> notes;  // about flags that have no effect
};

// Returns nothing if the words do not call a stock tool: neither is `program` the path of one, nor is the
// first word after --basedir and --game its name. Errors are kUsage: an unknown flag, with the nearest known
// one; a flag of something that Temblor does not do; a missing value or file.
base::Result<std::optional<StockCommand>> parse_stock_command(std::string_view program,
                                                              std::span<const char* const> words);

// Prints notes, then runs the stage or prints the flags.
base::Status run_stock_command(const StockCommand& command);

}  // namespace temblor::app
