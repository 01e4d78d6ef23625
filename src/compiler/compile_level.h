// The whole way from map text to a level that is played: the stages in their order, each only where its
// result would not be what is there already.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/build/compile_watcher.h"
#include "compiler/light/light_level.h"
#include "compiler/make_draft.h"
#include "compiler/report.h"
#include "compiler/texture_set.h"

namespace temblor::compiler {

enum class StagePolicy : std::uint8_t {
  kBuild,  // as the map and the options ask for it
  kReuse,  // as it is, if it still fits the brushes; else left out
  kSkip,   // without visibility everything is drawn, without light everything is bright
};

struct CompileOptions {
  DraftOptions draft;
  LightOptions light;  // its palette is filled in
  MipLevels mip_levels = MipLevels::kFromSource;
  StagePolicy visibility_wish = StagePolicy::kBuild, light_wish = StagePolicy::kBuild;
  bool fast_visibility = false;  // from the sides of planes alone
  bool bsp2 = false;             // though the level fits the original's format
};

struct StageTime {
  const char* name;
  std::optional<double> wall_s;  // nothing: what was there was kept
};

struct CompileReport {
  std::optional<LeakPath> leak;  // then there is no visibility
  std::vector<StageTime> times;
};

// Brings `io_build` up to date with the map. Every texture of the map that no source has is a checker, and a
// warning. The bytes of the level depend neither on the number of threads nor on what was built before (but
// for stages that are kept). When `watcher` says stop: kUsage, and io_build has the visibility that is done.
// After an error what the build has still belongs together, though some of it may be gone.
base::Result<CompileReport> compile_level(const formats::Map& map, std::span<const TextureSource> sources,
                                          const formats::Palette& palette, const CompileOptions& options,
                                          base::Jobs& jobs, CompileWatcher& watcher, Build& io_build,
                                          Warnings& io_warnings);

// A level whose map is not at hand, as a build: portals from its tree, keys of faces from its entity text
// (those of func_group and func_detail are lost).
base::Result<Build> build_of_level(formats::Bsp bsp, std::optional<formats::Lit> lit,
                                   bool water_is_transparent);

// The stages after BSP alone.
base::Result<CompileReport> finish_level(const formats::Palette& palette, const CompileOptions& options,
                                         base::Jobs& jobs, CompileWatcher& watcher, Build& io_build,
                                         Warnings& io_warnings);

}  // namespace temblor::compiler
