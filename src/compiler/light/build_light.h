// The light stage of a Build: lights the level and stores the result with its key.
#pragma once

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/light/light_level.h"
#include "compiler/report.h"

namespace temblor::compiler {

// The key of the light that the build would get; equal to its light_key if it has that light already. Fails
// if the entity text does not parse.
base::Result<StageKey> find_light_key(const Build& build, const LightOptions& options);

// Lights the level with the help of the build's light cache, and updates the cache. Fails as light_level()
// does.
base::Status make_light(const LightOptions& options, base::Jobs& jobs, Progress progress, Build& io_build,
                        Warnings& io_warnings);

// Stores light that belongs to the level.
void set_light(LightSummary light, StageKey key, Build& io_build);

// Keeps the light although the entity text is new: writes the styles of switchable lights into the text
// again.
base::Status reuse_light(Build& io_build);

// Makes the level fully lit: without light maps, faces show their textures as they are.
void remove_light(Build& io_build);

}  // namespace temblor::compiler
