// The mapper's options on the command line of the compiler. The options of the level itself are in its
// entities' keys.
#pragma once

#include <cstdint>

#include "compiler/bsp/make_draft.h"
#include "compiler/light/light_level.h"
#include "compiler/texture_set.h"

namespace temblor::compiler {

// The decision about one stage of the pipeline.
enum class StagePolicy : std::uint8_t {
  kBuild,  // run it, unless its last result is still valid
  kReuse,  // keep its last result if that still fits the brushes; otherwise leave it out
  kSkip,   // leave it out: without visibility everything is drawn, without light everything is fully lit
};

// The defaults are those of `temblor compile` without options.
struct CompileOptions {
  DraftOptions draft;
  LightOptions light;  // compile_level and finish_level fill in its palette
  MipLevels mip_levels = MipLevels::kFromSource;
  StagePolicy visibility_policy = StagePolicy::kBuild;
  StagePolicy light_policy = StagePolicy::kBuild;
  bool fast_visibility = false;  // VisibilityKind::kRough instead of kFull
  // The format is version 30 if draft.half_life; else BSP2 or 2PSB if the option says so; else version 29, or
  // BSP2 if the level does not fit it.
  bool bsp2 = false, psb2 = false;
};

}  // namespace temblor::compiler
