// `temblor compile`: from an editor's .map to a level, and what is told of it.
#pragma once

#include "app/commands/options.h"
#include "app/compile/compile_options.h"
#include "base/result.h"

namespace CLI {
class App;
}

namespace temblor::app {

CLI::App* add_compile_command(CLI::App& program, CompileCommandOptions& io_options);

// One run, a share of one, or one after another (--watch).
base::Status run_compile(const CompileCommandOptions& options, const GameFolders& folders);

}  // namespace temblor::app
