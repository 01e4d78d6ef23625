// The incremental build manager: decides for each stage of the pipeline whether to run it, to reuse its last
// result, or to leave it out, and keeps the keys of a Build in step with its results.
//
// A result is reused if its key, a hash of everything that the stage reads (build_keys.h), is still the same.
// The keys depend on contents only, never on the time or on the files' dates.
#pragma once

#include "base/result.h"
#include "compiler/bsp/make_draft.h"
#include "compiler/build.h"
#include "compiler/compile_options.h"
#include "compiler/texture_set.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Made for one run of the pipeline. Call choose_...() before each stage, then do as it says.
class IncrementalBuild {
 public:
  // Both outlive this.
  IncrementalBuild(const CompileOptions& options, Build& io_build) : options_(options), build_(io_build) {}

  // kBuild or kReuse. Remembers the map's key for store_bsp().
  StagePolicy choose_bsp(const formats::Map& map, const TextureSet& textures);
  // Keeps geometry, visibility and light, and updates what needs no stage: textures and entities.
  void reuse_bsp(const formats::Map& map, const TextureSet& textures);
  // Replaces the build by a new draft. The old light cache and unfinished visibility stay: parts of them may
  // still be valid. Fails if the level is too large for the file format.
  base::Status store_bsp(DraftResult made, bool leaks, const formats::Map& map, const TextureSet& textures);

  // kSkip: the level has no visibility and gets none.
  StagePolicy choose_visibility(bool leaks) const;
  // The kind that the options ask for.
  VisibilityKind wanted_visibility() const;

  // kReuse also for a level without any light of ours; then there is nothing to do. Fails if the entity text
  // does not parse.
  base::Result<StagePolicy> choose_light(const LightOptions& options) const;

 private:
  bool is_bsp_up_to_date(const formats::Map& map) const;

  const CompileOptions& options_;
  Build& build_;
  StageKey brushes_key_ = 0;  // of the map at hand
};

}  // namespace temblor::compiler
