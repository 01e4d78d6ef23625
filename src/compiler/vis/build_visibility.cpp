#include "compiler/vis/build_visibility.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "compiler/vis/visibility_lump.h"
#include "compiler/vis/visibility_state.h"

namespace temblor::compiler {
namespace {

using Clock = std::chrono::steady_clock;

// Each time the searches begin anew, which takes seconds on the largest levels.
constexpr std::chrono::seconds kSaveEvery{120};

VisibilityState resumed(const Build& build, const SearchablePortals& portals) {
  VisibilityState begun = begin_visibility(portals);
  if (build.visibility_state.empty()) return begun;
  base::Result<VisibilityState> saved = read_visibility_state(build.visibility_state, begun);
  // Of other portals: the brushes were changed since.
  return saved.ok() ? std::move(saved).value() : std::move(begun);
}

base::Status set_visibility(const BitMatrix& visible, VisibilityKind kind, Build& io_build) {
  TRY_STATUS(write_visibility(io_build.portals, visible, {}, io_build.bsp));
  io_build.mean_visible_share = mean_visible_share(io_build.portals, visible);
  io_build.visibility = kind;
  return base::Ok{};
}

// Stops now and then to save what is done.
base::Status work_out(const SearchablePortals& portals, base::Jobs& jobs, CompileWatcher& watcher,
                      VisibilityState& io_state) {
  for (;;) {
    const Clock::time_point start = Clock::now();
    bool stopped = false;
    const auto progress = [&](std::size_t done, std::size_t total) {
      stopped = !watcher.progress(done, total);
      return !stopped && Clock::now() - start < kSaveEvery;
    };
    if (continue_visibility(portals, jobs, progress, io_state) == VisibilityEnd::kFinished) return base::Ok{};
    if (stopped) return base::error(base::ErrorCode::kUsage, "stopped while working out visibility");
    watcher.save(write_visibility_state(io_state));
  }
}

}  // namespace

base::Status make_visibility(VisibilityKind kind, base::Jobs& jobs, CompileWatcher& watcher,
                             Build& io_build) {
  const SearchablePortals portals(io_build.portals);
  if (kind == VisibilityKind::kRough)
    return set_visibility(roughly_visible_clusters(portals, jobs), kind, io_build);
  VisibilityState state = resumed(io_build, portals);
  const base::Status end = work_out(portals, jobs, watcher, state);
  io_build.visibility_state = write_visibility_state(state);  // also if light is stopped after it
  TRY_STATUS(end);
  return set_visibility(visible_clusters(portals, state), kind, io_build);
}

VisibilityShard make_visibility_shard(const Build& build, WorkShare share, base::Jobs& jobs,
                                      Progress progress) {
  const SearchablePortals portals(build.portals);
  VisibilityState state = resumed(build, portals);
  const VisibilityEnd end = continue_visibility(portals, jobs, progress, state, share);
  return {write_visibility_state(state), end};
}

base::Result<MergedVisibility> merge_visibility_shards(std::span<const base::Bytes> shards, Build& io_build) {
  if (shards.empty()) return base::error(base::ErrorCode::kUsage, "no shards of visibility to merge");
  const SearchablePortals portals(io_build.portals);
  VisibilityState state = resumed(io_build, portals);
  const VisibilityState begun = begin_visibility(portals);
  for (const base::Bytes bytes : shards) {
    TRY(const VisibilityState shard, read_visibility_state(bytes, begun));
    TRY_STATUS(merge_visibility_state(shard, state));
  }
  const auto finished = std::ranges::count(state.finished, 1);
  const MergedVisibility merged{static_cast<std::size_t>(finished), state.finished.size()};
  if (merged.finished_portals < merged.portals) {
    io_build.visibility_state = write_visibility_state(state);
  } else {
    TRY_STATUS(set_visibility(visible_clusters(portals, state), VisibilityKind::kFull, io_build));
    io_build.visibility_state.clear();
  }
  return merged;
}

}  // namespace temblor::compiler
