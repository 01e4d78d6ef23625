// The visibility stage of a Build: computes visibility, continuing from where an earlier run stopped, and
// stores it.
#pragma once

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/report.h"
#include "compiler/vis/visibility.h"

namespace temblor::compiler {

// Continues from the build's visibility_state if that belongs to its portals. Fails with kUsage if the
// watcher stops it; visibility_state then holds what is done. Afterwards visibility_state holds the finished
// state, until the level is safe: light may still be stopped.
base::Status make_visibility(VisibilityKind kind, base::Jobs& jobs, CompileWatcher& watcher, Build& io_build);

// Returns the build's saved state, or an empty one if there is none or if it belongs to other portals.
VisibilityState resume_visibility(const Build& build, const SearchablePortals& portals);

// Writes visibility into the level. `visible` has a row and a column for each cluster of the build's portals.
base::Status set_visibility(const BitMatrix& visible, VisibilityKind kind, Build& io_build);

}  // namespace temblor::compiler
