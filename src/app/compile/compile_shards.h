// Splits visibility or light among processes that share a file system. Each process writes its part to a file
// next to the level, castle.vis-2-of-4, and a last run merges the files:
//
//   compile castle.map --only vis --shard 1/4   ...   --shard 4/4   (on any machines)
//   compile castle.map --only vis --merge
#pragma once

#include "app/compile/compile_options.h"
#include "app/compile/compile_session.h"
#include "base/result.h"

namespace temblor::app {

// Computes a shard of `stage` (visibility or light) and writes its file. Ctrl-C saves the part that is done
// and returns an error. Light is saved every two minutes and resumes from its own file; visibility resumes
// after --merge has joined the files. Visibility of a level that leaks is an error.
base::Status run_shard(CompileStage stage, const Shard& shard, CompileSession& io_session);

// Merges the files of all shards of `stage`, writes the level, and removes the files. Prints how much of
// visibility is done. Missing visibility shards are not an error: what is done so far is kept, and the shards
// can be run again.
base::Status merge_shards(CompileStage stage, CompileSession& io_session);

}  // namespace temblor::app
