// `temblor compile`: compiles an editor's .map to a level, and reports leaks, limits, and times. The work is
// done by the compiler library; the files in app/compile read and write its files and print its results.
#pragma once

#include "app/commands/options.h"
#include "app/compile/compile_options.h"
#include "base/result.h"

namespace temblor::app {

class Command;

Command* add_compile_command(Command& program, CompileCommandOptions& io_options);

// Compiles once, computes or merges shards, compiles after every change (--watch), or makes a WAD, as the
// options say.
base::Status run_compile(const CompileCommandOptions& options, const GameFolders& folders);

}  // namespace temblor::app
