// The light stage of a Build: at once, or in shares.
#pragma once

#include <span>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/light/light_level.h"
#include "compiler/report.h"

namespace temblor::compiler {

// Of what the build's light would be made; equal to its light_key when it is that already. Fails on entity
// text that does not parse.
base::Result<StageKey> light_key_of(const Build& build, const LightOptions& options);

base::Status make_light(const LightOptions& options, base::Jobs& jobs, Progress progress, Build& io_build,
                        Warnings& io_warnings);

// For entity text that is new while light is not: styles of switchable lights are written into it.
base::Status keep_light(Build& io_build);

void remove_light(Build& io_build);

// Joins shards (light_shard), all of them, to what make_light would have made.
base::Status merge_light_shards(std::span<const base::Bytes> shards, const LightOptions& options,
                                base::Jobs& jobs, Build& io_build, Warnings& io_warnings);

}  // namespace temblor::compiler
