// The build file beside a level: what a Build has beyond the .bsp and .lit files, so that a later run can
// redo only what has changed. Levels play without it.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/build.h"

namespace temblor::compiler {

// The bytes of the level's files; `lit` is empty if there is none.
struct LevelFiles {
  base::Bytes bsp, lit;
};

// Returns the same bytes for equal builds. `files` were written from this build. Unfinished visibility is not
// included: it has a file of its own, since it outlives the level.
base::ByteVector write_build(const Build& build, const LevelFiles& files);

// Returns the build that `files` belong to, or an empty build if they are not the files that were written
// with it. Fails with kUnsupported for another version and with kMalformed if the bytes are damaged.
base::Result<Build> read_build(base::Bytes bytes, const LevelFiles& files);

}  // namespace temblor::compiler
