// `temblor compile`: from an editor's .map to a level, and what is told of it.
#pragma once

#include "app/commands/options.h"
#include "app/compile/compile_options.h"
#include "base/result.h"

namespace temblor::app {

class Command;

Command* add_compile_command(Command& program, CompileCommandOptions& io_options);

// One run, a share of one, or one after another (--watch).
base::Status run_compile(const CompileCommandOptions& options, const GameFolders& folders);

}  // namespace temblor::app
