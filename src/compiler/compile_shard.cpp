// Every process reads the same Build, so the fingerprints and hashes in shards tell which of them belong
// together.
#include "compiler/compile_shard.h"

#include <algorithm>
#include <utility>

#include "compiler/light/build_light.h"
#include "compiler/vis/build_visibility.h"
#include "compiler/vis/visibility_state.h"

namespace temblor::compiler {

VisibilityShard make_visibility_shard(const Build& build, WorkShare share, base::Jobs& jobs,
                                      Progress progress) {
  const SearchablePortals portals(build.portals);
  VisibilityState state = resume_visibility(build, portals);
  const VisibilityEnd end = continue_visibility(portals, jobs, progress, state, share);
  return {write_visibility_state(state), end};
}

base::Result<MergedVisibility> merge_visibility_shards(std::span<const NamedShard> shards, Build& io_build) {
  if (shards.empty()) return base::error(base::ErrorCode::kUsage, "there are no visibility shards to merge");
  const SearchablePortals portals(io_build.portals);
  VisibilityState state = resume_visibility(io_build, portals);
  const VisibilityState begun = begin_visibility(portals);
  for (const NamedShard& named : shards) {
    TRY(const VisibilityState shard, read_visibility_state(named.bytes, begun).with_file(named.file));
    TRY_STATUS(merge_visibility_state(shard, state).with_file(named.file));
  }
  const auto finished = std::ranges::count(state.finished, 1);
  const MergedVisibility merged{static_cast<std::size_t>(finished), state.finished.size()};
  if (merged.finished_portals < merged.portals) {
    io_build.visibility_state = write_visibility_state(state);
  } else {
    TRY_STATUS(set_visibility(find_visible_clusters(portals, state), VisibilityKind::kFull, io_build));
    io_build.visibility_state.clear();
  }
  return merged;
}

base::Result<LightShardBytes> make_light_shard(const Build& build, WorkShare share,
                                               const LightOptions& options, base::Bytes begun,
                                               base::Jobs& jobs, Progress progress) {
  return light_shard(build.bsp, build.face_keys, options, {share.index, share.count}, begun, jobs, progress);
}

base::Status merge_light_shards(std::span<const NamedShard> shards, const LightOptions& options,
                                base::Jobs& jobs, Build& io_build, Warnings& io_warnings) {
  TRY(const StageKey key, find_light_key(io_build, options));
  TRY(LightSummary light, merge_light(io_build.bsp, io_build.face_keys, options, shards, jobs, io_warnings));
  set_light(std::move(light), key, io_build);
  return base::Ok{};
}

}  // namespace temblor::compiler
