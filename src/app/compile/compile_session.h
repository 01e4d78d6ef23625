// One `temblor compile`: its source, what earlier runs left, and the stages that it runs.
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

// A .bsp, and no map.
bool is_level(const std::filesystem::path& source);

class CompileSession {
 public:
  // Finds the palette and what earlier runs left of the level. kUsage where the level would be written over
  // the map, or over a file of its own.
  static base::Result<std::unique_ptr<CompileSession>> begin(const CompileCommandOptions& options,
                                                             const GameFolders& folders);

  // Reads the source and runs the stages that the command line asks for. Does not write the level.
  base::Result<compiler::CompileReport> run();
  // The BSP stage alone: what visibility and light begin with.
  base::Result<compiler::CompileReport> run_bsp();

  compiler::Build& build() { return build_; }
  const LevelPaths& paths() const { return paths_; }
  base::Jobs& jobs() { return jobs_; }
  // Whether the last run ended because of Ctrl-C.
  bool was_interrupted() const { return interrupt_.was_noted(); }
  Interrupt& interrupt() { return interrupt_; }
  compiler::LightOptions light_options() const;
  // What the last run read, each as it was before that; also when the run failed.
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
  Interrupt interrupt_;  // before the threads of jobs_
  base::Jobs jobs_;
  compiler::Build build_;
  std::vector<FileStamp> source_files_;
};

}  // namespace temblor::app
