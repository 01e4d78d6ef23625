#include "compiler/vis/build_visibility.h"

#include <chrono>
#include <utility>

#include "compiler/vis/visibility_lump.h"
#include "compiler/vis/visibility_state.h"

namespace temblor::compiler {
namespace {

using VisibilityClock = std::chrono::steady_clock;

// Between saves. After each, the searches start again with what is finished, which takes seconds on the
// largest levels.
constexpr std::chrono::seconds kSaveEvery{120};

// Computes visibility, and stops now and then to save what is done.
base::Status compute_in_steps(const SearchablePortals& portals, base::Jobs& jobs, CompileWatcher& watcher,
                              VisibilityState& io_state) {
  for (;;) {
    const VisibilityClock::time_point start = VisibilityClock::now();
    bool stopped = false;
    const auto progress = [&](std::size_t done, std::size_t total) {
      stopped = !watcher.progress(done, total);
      return !stopped && VisibilityClock::now() - start < kSaveEvery;
    };
    if (continue_visibility(portals, jobs, progress, io_state) == VisibilityEnd::kFinished) return base::Ok{};
    if (stopped) return base::error(base::ErrorCode::kUsage, "visibility was stopped");
    watcher.save(write_visibility_state(io_state));
  }
}

}  // namespace

VisibilityState resume_visibility(const Build& build, const SearchablePortals& portals) {
  VisibilityState begun = begin_visibility(portals);
  if (build.visibility_state.empty()) return begun;
  base::Result<VisibilityState> saved = read_visibility_state(build.visibility_state, begun);
  // It belongs to other portals if the brushes were changed since.
  return saved.ok() ? std::move(saved).value() : std::move(begun);
}

// Nothing changes if the lump would be too large.
base::Status set_visibility(const BitMatrix& visible, VisibilityKind kind, Build& io_build) {
  TRY_STATUS(write_visibility(io_build.portals, visible, {}, io_build.bsp));
  io_build.mean_visible_share = mean_visible_share(io_build.portals, visible);
  io_build.visibility = kind;
  return base::Ok{};
}

base::Status make_visibility(VisibilityKind kind, base::Jobs& jobs, CompileWatcher& watcher,
                             Build& io_build) {
  const SearchablePortals portals(io_build.portals);
  if (kind == VisibilityKind::kRough)
    return set_visibility(find_roughly_visible_clusters(portals, jobs), kind, io_build);
  VisibilityState state = resume_visibility(io_build, portals);
  const base::Status end = compute_in_steps(portals, jobs, watcher, state);
  if (end.ok()) state.swept = {};                             // later runs do not need it
  io_build.visibility_state = write_visibility_state(state);  // kept in case light is stopped
  TRY_STATUS(end);
  return set_visibility(find_visible_clusters(portals, state), kind, io_build);
}

}  // namespace temblor::compiler
