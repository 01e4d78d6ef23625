// The map compiler's pipeline, from the brushes and entities of a map to a level that can be played:
//
//   Map --textures--> TextureSet --bsp--> Draft --visibility--> PVS --light--> light maps
//
// Each stage runs only if its last result is out of date; build/incremental_build.h decides that. The stages
// are bsp/make_draft.h (qbsp in Quake's own tools), vis/build_visibility.h (vis), and light/build_light.h
// (light).
//
// The bytes of the level depend neither on the number of threads nor on what was built before, except for
// stages with StagePolicy::kReuse.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build.h"
#include "compiler/compile_options.h"
#include "compiler/report.h"
#include "compiler/texture_set.h"
#include "formats/images/palette.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// The parts that a level is made of. Everything must outlive the call.
struct LevelSource {
  const formats::Map& map;                  // with its prefabs expanded (prefabs.h)
  std::span<const TextureSource> textures;  // the first one that has a texture provides it
  const formats::Palette& palette;
};

// The services for every stage. Everything must outlive the call.
struct CompileContext {
  base::Jobs& jobs;
  CompileWatcher& watcher;
  Warnings& warnings;  // stages append to it
};

// How long one stage took.
struct StageTime {
  const char* name;
  std::optional<double> wall_s;  // nothing: the last result was reused
};

// The results of a run.
struct CompileReport {
  std::optional<LeakPath> leak;               // if the level leaks, there is no visibility
  std::vector<StageTime> times;               // in the order of the stages
  std::vector<std::string> missing_textures;  // names that no source has
};

// Brings `io_build` up to date with the map. A texture that no source has becomes a checkerboard, with a
// warning.
//
// Fails with kUsage if the watcher stops it; io_build then holds the visibility computed so far. After any
// error the parts of the build still fit each other, though some may be missing.
base::Result<CompileReport> compile_level(const LevelSource& source, const CompileOptions& options,
                                          const CompileContext& context, Build& io_build);

// Runs the stages after BSP on a build, for example one of make_build_from_level().
base::Result<CompileReport> finish_level(const formats::Palette& palette, const CompileOptions& options,
                                         const CompileContext& context, Build& io_build);

}  // namespace temblor::compiler
