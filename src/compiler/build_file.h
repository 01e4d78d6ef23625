// What a Build has beyond the level's own files, as bytes: the file beside the level that lets a later run
// make anew only what changed.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/build.h"

namespace temblor::compiler {

// The level's files as they lie beside it; `lit` is empty where there is none.
struct LevelFiles {
  base::Bytes bsp, lit;
};

// The same bytes for equal builds. `files`: those written of this build.
base::ByteVector write_build(const Build& build, const LevelFiles& files);

// A build of which nothing but visibility that is begun is worth keeping: its level was not written.
base::ByteVector write_unfinished_build(base::Bytes visibility_state);

// The build whose level `files` are. Where they are not those that it was written with, nothing is kept but
// visibility that is begun. kUnsupported: of another version; kMalformed: damaged.
base::Result<Build> read_build(base::Bytes bytes, const LevelFiles& files);

}  // namespace temblor::compiler
