// Visibility and light shared out among processes that have a file system in common, by files beside the
// level: castle.vis-2-of-4.
#pragma once

#include "app/compile/compile_options.h"
#include "app/compile/compile_session.h"
#include "base/result.h"

namespace temblor::app {

// Works out a share of `stage` (visibility or light) and writes its file. Ctrl-C leaves what is done of the
// share in it; then, and for visibility of a level that leaks, an error. A share of light is saved every two
// minutes, and goes on from its file; one of visibility, once --merge has joined what there is.
base::Status run_shard(CompileStage stage, const Shard& shard, CompileSession& io_session);

// Joins the files of all shards of `stage`, writes the level and takes them away; says how far the stage is.
base::Status merge_shards(CompileStage stage, CompileSession& io_session);

}  // namespace temblor::app
