// A compiled level on disk: the .bsp, and what lies beside it under the same name.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/files/atomic_write.h"
#include "base/bytes.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/make_draft.h"

namespace temblor::app {

struct LevelPaths {
  std::filesystem::path bsp;
  std::filesystem::path lit;           // colored light
  std::filesystem::path points;        // .pts: the way of a leak, as editors show it
  std::filesystem::path leak_picture;  // .leak.png
  std::filesystem::path build;         // .build: what lets the next run keep what did not change
  std::filesystem::path visibility;    // .visibility: begun and not finished, of whatever is being compiled
};
LevelPaths level_paths(const std::filesystem::path& bsp);

// What earlier runs left; an empty build where nothing is there, or nothing that can be used.
compiler::Build read_build_file(const LevelPaths& paths);

// A level made ready: its bytes, and the steps that put it on disk. Wherever the steps are cut short, no
// level lies beside colors of another: those that no longer fit go first, and new ones come after their
// level.
struct PreparedLevel {
  base::ByteVector bsp;
  std::optional<base::ByteVector> lit;
  std::vector<FileChange> steps;
};
base::Result<PreparedLevel> prepare_level(const compiler::Build& build,
                                          const std::optional<compiler::LeakPath>& leak,
                                          const LevelPaths& paths);

// Writes what the build has and takes away what it has not, each file whole or not at all; a full disk leaves
// the old level and all beside it. `keep`: with the build file.
base::Status write_level(const compiler::Build& build, const std::optional<compiler::LeakPath>& leak,
                         const LevelPaths& paths, bool keep);

// Saves visibility that is begun; the level stays as it is.
base::Status write_visibility_begun(base::Bytes visibility_state, const LevelPaths& paths);

}  // namespace temblor::app
