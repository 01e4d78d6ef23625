// The visibility stage of a Build: at once, going on from where it stopped, or in shares.
#pragma once

#include <span>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/build/compile_watcher.h"
#include "compiler/report.h"
#include "compiler/vis/visibility.h"

namespace temblor::compiler {

// Goes on from the build's visibility_state, if that is of its portals. kUsage when the watcher says stop;
// what is done then lies in visibility_state.
base::Status make_visibility(VisibilityKind kind, base::Jobs& jobs, CompileWatcher& watcher, Build& io_build);

struct VisibilityShard {
  base::ByteVector state;  // for merge_visibility_shards
  VisibilityEnd end;
};
// Works out a share of the first round that visibility_state has not finished; or less of it, when `progress`
// says stop.
VisibilityShard make_visibility_shard(const Build& build, WorkShare share, base::Jobs& jobs,
                                      Progress progress);

struct MergedVisibility {
  std::size_t finished_portals, portals;
};
// Joins shards to the build's visibility_state; when nothing is left to do the build has its visibility.
// Errors: those of read_visibility_state, and kUsage without any shard; the build is then as it was.
base::Result<MergedVisibility> merge_visibility_shards(std::span<const base::Bytes> shards, Build& io_build);

}  // namespace temblor::compiler
