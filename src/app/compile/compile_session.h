// One `temblor compile`: its source, the results of earlier runs, and the stages to run.
//
//   .map -> bsp -> visibility -> light -> Build -> .bsp, .lit (level_output.h)
//                                           ^
//   .build, .visibility of earlier runs ----'
//
// The compiler library reuses every part of the Build whose input has not changed. The session only reads
// files, shows progress, and handles Ctrl-C; level_output.h writes the result. For --watch, run() may be
// called repeatedly.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/commands/options.h"
#include "app/compile/compile_options.h"
#include "app/compile/level_output.h"
#include "app/files/file_watch.h"
#include "app/files/interrupt.h"
#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/compile_level.h"
#include "formats/images/palette.h"

namespace temblor::app {

// Returns whether the source is a .bsp, not a .map.
bool is_level(const std::filesystem::path& source);

class CompileSession {
 public:
  // Finds the palette and reads the results of earlier runs. kUsage if the output would overwrite the map or
  // one of the files beside the level.
  static base::Result<std::unique_ptr<CompileSession>> begin(const CompileCommandOptions& options,
                                                             const GameFolders& folders);

  // Reads the source and runs the stages that the options ask for. Does not write the level.
  base::Result<compiler::CompileReport> run();
  // Runs only the BSP stage, whose result visibility and light need.
  base::Result<compiler::CompileReport> run_bsp();

  // The results so far. Valid after a successful run.
  compiler::Build& build() { return build_; }
  const LevelPaths& paths() const { return paths_; }
  base::Jobs& jobs() { return jobs_; }
  // Returns whether Ctrl-C ended the last run.
  bool was_interrupted() const { return interrupt_.was_requested(); }
  Interrupt& interrupt() { return interrupt_; }
  compiler::LightOptions light_options() const;
  // The warnings of the last run.
  const compiler::Warnings& warnings() const { return warnings_; }
  const formats::Palette& palette() const { return palette_; }
  // Stamps of the files that the last run read, taken before reading. Also valid after a failure.
  const std::vector<FileStamp>& source_files() const { return source_files_; }

 private:
  CompileSession(const CompileCommandOptions& options, formats::Palette palette, LevelPaths paths);

  base::Result<compiler::CompileReport> run(const compiler::CompileOptions& how);
  base::Result<compiler::CompileReport> run_map(const compiler::CompileOptions& how,
                                                compiler::CompileWatcher& watcher,
                                                compiler::Warnings& io_warnings);

  CompileCommandOptions options_;
  formats::Palette palette_;
  LevelPaths paths_;
  std::vector<std::filesystem::path> game_wads_;
  // Constructed before jobs_, whose threads inherit its signal mask.
  Interrupt interrupt_;
  base::Jobs jobs_;
  compiler::Build build_;
  std::vector<FileStamp> source_files_;
  compiler::Warnings warnings_;
};

}  // namespace temblor::app
