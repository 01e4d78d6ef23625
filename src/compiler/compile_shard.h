// Visibility and light of one level computed by several processes, each of which makes a shard; one of them
// merges all shards into its Build. A merged level is, byte for byte, the one that a single process makes.
#pragma once

#include <cstddef>
#include <span>

#include "base/bytes.h"
#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/light/light_level.h"
#include "compiler/report.h"
#include "compiler/vis/visibility.h"

namespace temblor::compiler {

// The work of one process on visibility.
struct VisibilityShard {
  base::ByteVector state;  // for merge_visibility_shards()
  VisibilityEnd end;
};
// Computes a share of the first round that the build's visibility_state has not finished, or less if
// `progress` stops it.
VisibilityShard make_visibility_shard(const Build& build, WorkShare share, base::Jobs& jobs,
                                      Progress progress);

// How far the merged visibility is.
struct MergedVisibility {
  std::size_t finished_portals, portals;
};
// Adds shards to the build's visibility_state. When nothing is left to do, the build gets its visibility.
// Fails with the errors of read_visibility_state(), which name the file of the shard, and with kUsage without
// any shard; the build is then unchanged.
base::Result<MergedVisibility> merge_visibility_shards(std::span<const NamedShard> shards, Build& io_build);

// Lights every share.count-th light map, beginning with map share.index. `begun`: an earlier result for the
// same share, to continue; empty or anything else: start over. The finished bytes do not depend on how often
// the work was stopped.
base::Result<LightShardBytes> make_light_shard(const Build& build, WorkShare share,
                                               const LightOptions& options, base::Bytes begun,
                                               base::Jobs& jobs, Progress progress);

// Merges all shards, in any order, into the light that make_light() would have made. Fails with kUsage if a
// shard is missing, duplicate or unfinished, or belongs to another level or other options.
base::Status merge_light_shards(std::span<const NamedShard> shards, const LightOptions& options,
                                base::Jobs& jobs, Build& io_build, Warnings& io_warnings);

}  // namespace temblor::compiler
