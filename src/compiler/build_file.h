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

// The same bytes for equal builds. `files`: those written of this build. Visibility that is begun is not in
// it: that lasts longer than the level.
base::ByteVector write_build(const Build& build, const LevelFiles& files);

// The build whose level `files` are; an empty one where they are not those that it was written with.
// kUnsupported: of another version; kMalformed: damaged.
base::Result<Build> read_build(base::Bytes bytes, const LevelFiles& files);

}  // namespace temblor::compiler
