// `temblor inspect`: describes a file of any known format and lists its problems.
#pragma once

#include <string>

#include "app/inspect/model_sheet.h"
#include "base/result.h"

namespace temblor::app {

class Command;

struct InspectOptions {
  std::string file;
  // Print JSON instead of text.
  bool json = false;
  // A picture of a model, which is drawn if sheet.out is not empty.
  SheetOptions sheet;
};

Command* add_inspect_command(Command& program, InspectOptions& io_options);

// Prints the inspection. A file that its reader rejects is an error; with --json, the command then also
// prints an object with the key "error", so that scripts always get JSON.
base::Status run_inspect(const InspectOptions& options);

}  // namespace temblor::app
