// `temblor compile --report`: one HTML page about a compiled level, for mappers. It needs no other file and
// no script.
#pragma once

#include <string>

#include "base/result.h"
#include "compiler/build.h"
#include "compiler/compile_level.h"
#include "compiler/report.h"
#include "formats/images/palette.h"

namespace temblor::app {

struct LevelReportInput {
  const compiler::Build& build;             // with a level
  const compiler::CompileReport& compiled;  // of the run that made it
  const compiler::Warnings& warnings;       // of the same run
  const formats::Palette& palette;          // for pictures of textures
  std::string level_file;                   // for the title
  std::size_t level_bytes = 0;              // the size of that file
};

// Returns the page: times, problems, a leak with a picture, limits, the plan with portals and visibility,
// light, surfaces by the size of their light maps, and textures. Fails if the level is not valid or if a
// picture cannot be written.
base::Result<std::string> make_level_report(const LevelReportInput& input);

}  // namespace temblor::app
