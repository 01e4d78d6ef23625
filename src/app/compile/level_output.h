// Writes a compiled level: the .bsp and its side files, which have the same name with other extensions. All
// files are prepared before the first one is replaced (files/atomic_write.h).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/files/atomic_write.h"
#include "base/bytes.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/report.h"
#include "math/vec.h"

namespace temblor::app {

struct LevelPaths {
  std::filesystem::path bsp;
  // .lit: colored light.
  std::filesystem::path lit;
  // .lux: directions of light.
  std::filesystem::path lux;
  // .pts: path of a leak, which editors can show.
  std::filesystem::path points;
  // .leak.png: the same as a picture.
  std::filesystem::path leak_picture;
  // .prt: the portals, for visibility programs.
  std::filesystem::path portals;
  // .build: inputs and results, so that the next run can reuse them.
  std::filesystem::path build;
  // .visibility: state of an interrupted visibility stage.
  std::filesystem::path visibility;
};
LevelPaths make_level_paths(const std::filesystem::path& bsp);

// Reads the results of earlier runs; an empty build if there are none or they cannot be used.
compiler::Build read_build_file(const LevelPaths& paths);

// A level that is ready to be written: its bytes, and the file changes in order. If the process is killed
// between two steps, there is never a level with the colors of another one:
//
//   1. leak files, portals   2. remove old .lit, .lux   3. replace .bsp   4. add new .lit, .lux
struct PreparedLevel {
  base::ByteVector bsp;
  std::optional<base::ByteVector> lit, lux;
  std::vector<FileChange> steps;
};
// The side files of a level.
struct SideFiles {
  // Write the build file; otherwise it is removed.
  bool build = true;
  // Write the portal file; a level that leaks has none. Otherwise it stays as it is.
  bool portals = false;
  // Write or remove the files of a leak. False: the BSP stage did not run, so they stay as they are.
  bool leak = true;
  // Write a .lit file even if all light is white.
  bool lit = false;
};
base::Result<PreparedLevel> prepare_level(const compiler::Build& build,
                                          const std::optional<compiler::LeakPath>& leak,
                                          const LevelPaths& paths, const SideFiles& wanted = {});

// Writes the level and its side files and removes side files that no longer apply. Each file is replaced
// atomically; on a full disk all old files stay.
base::Status write_level(const compiler::Build& build, const std::optional<compiler::LeakPath>& leak,
                         const LevelPaths& paths, const SideFiles& wanted);

// Adds points to the path of a leak, so that neighbors are at most `step` units apart; step > 0.
std::vector<math::Vec3d> space_points(const std::vector<math::Vec3d>& corners, double step);

// Saves the state of an interrupted visibility stage. Does not change the level.
base::Status write_partial_visibility(base::Bytes visibility_state, const LevelPaths& paths);

}  // namespace temblor::app
