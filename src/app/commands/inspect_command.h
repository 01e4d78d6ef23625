// `temblor inspect`: what a file holds, and what is wrong with it.
#pragma once

#include <string>

#include "app/inspect/model_sheet.h"
#include "base/result.h"

namespace temblor::app {

class Command;

struct InspectOptions {
  std::string file;
  bool json = false;
  SheetOptions sheet;  // drawn where it has a name
};

Command* add_inspect_command(Command& program, InspectOptions& io_options);

// Prints the inspection; a file that its reader refuses is an error (and with --json, an object with the key
// "error" as well).
base::Status run_inspect(const InspectOptions& options);

}  // namespace temblor::app
