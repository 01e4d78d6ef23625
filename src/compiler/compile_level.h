// The whole way from map text to a level that is played: the stages in their order.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/light_level.h"
#include "compiler/make_draft.h"
#include "compiler/report.h"
#include "compiler/texture_set.h"
#include "formats/lit.h"

namespace temblor::compiler {

struct CompileOptions {
  DraftOptions draft;
  LightOptions light;
  MipLevels mip_levels = MipLevels::kFromSource;
  // What is left out: a level without visibility shows everything, one without light is drawn full-bright.
  bool visibility = true, lighting = true;
  bool fast_visibility = false;  // from the sides of planes alone
};

struct StageTime {
  const char* name;
  double wall_s;
};

struct CompiledLevel {
  formats::Bsp bsp;
  // Lit samples for the file beside the level; nothing where all light is white.
  std::optional<formats::Lit> lit;
  std::optional<LeakWay> leak;               // then there is no visibility
  std::optional<double> mean_visible_share;  // of leafs, seen from a leaf
  LightSummary light;
  std::vector<StageTime> times;
};

// Told the name of the stage that begins; returns what reports its progress.
class CompileWatcher {
 public:
  virtual ~CompileWatcher() = default;
  virtual void begin_stage(const char* name) = 0;
  virtual bool progress(std::size_t done, std::size_t total) = 0;  // false: stop
};

// Every texture of the map that no source has is a checker, and a warning. The same bytes for any number of
// threads.
base::Result<CompiledLevel> compile_level(const formats::Map& map, std::span<const TextureSource> sources,
                                          const formats::Palette& palette, const CompileOptions& options,
                                          base::Jobs& jobs, CompileWatcher& watcher, Warnings& io_warnings);

}  // namespace temblor::compiler
