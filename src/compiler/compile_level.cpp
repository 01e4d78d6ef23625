#include "compiler/compile_level.h"

#include <chrono>
#include <string_view>
#include <utility>

#include "compiler/bsp/tree_portals.h"
#include "compiler/build/incremental_build.h"
#include "compiler/light/build_light.h"
#include "compiler/stock_limits.h"
#include "compiler/textures/level_textures.h"
#include "compiler/vis/build_visibility.h"
#include "compiler/world_keys.h"

namespace temblor::compiler {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Announces stages to the watcher, runs them, and records how long each takes.
class StageTimer {
 public:
  explicit StageTimer(CompileWatcher& watcher) : watcher_(watcher) {}

  template <typename Stage>
  auto run(const char* name, const Stage& stage) {
    watcher_.begin_stage(name);
    const Clock::time_point start = Clock::now();
    auto result = stage();
    times_.push_back({name, seconds_since(start)});
    return result;
  }
  void reuse(const char* name) { times_.push_back({name, std::nullopt}); }

  std::vector<StageTime> take_times() { return std::move(times_); }

 private:
  CompileWatcher& watcher_;
  std::vector<StageTime> times_;
};

// The stages of one run, in the order in which they are called.
class Pipeline {
 public:
  Pipeline(const formats::Palette& palette, const CompileOptions& options, const CompileContext& context,
           Build& io_build)
      : options_(options), context_(context), build_(io_build), manager_(options, io_build) {
    options_.light.palette = palette;
  }

  TextureSet load_textures(const LevelSource& source) {
    return stages_.run("textures", [&] {
      TextureSet textures = make_texture_set(find_texture_names(source.map), source.textures, source.palette,
                                             options_.mip_levels, context_.warnings);
      warn_about_missing_textures(source.map, textures, source.textures.size(), context_.warnings);
      if (options_.draft.half_life)
        for (formats::BspMiptex& texture : textures.miptexes)
          texture.palette.assign(source.palette.begin(), source.palette.end());
      missing_textures_ = textures.missing;
      return textures;
    });
  }

  base::Status make_bsp(const formats::Map& map, const TextureSet& textures) {
    if (manager_.choose_bsp(map, textures) == StagePolicy::kReuse) {
      stages_.reuse("bsp");
      manager_.reuse_bsp(map, textures);
      return base::Ok{};
    }
    const auto texture_size = [&](std::string_view name) { return find_texture_size(textures, name); };
    TRY(DraftResult made, stages_.run("bsp", [&] {
      return make_draft(map, texture_size, options_.draft, context_.jobs, context_.warnings, progress_);
    }));
    leak_ = std::move(made.leak);
    return manager_.store_bsp(std::move(made), leak_.has_value(), map, textures);
  }

  // For a level without a map: makes its portals again if the options see through water and the old ones do
  // not, or the other way round.
  base::Status update_portals() {
    const bool water_is_transparent = options_.draft.water_is_transparent;
    if (water_is_transparent == build_.water_is_transparent) return base::Ok{};
    TRY(build_.portals, make_tree_portals(build_.bsp, {water_is_transparent, Clusters::kSharedVisibility}));
    build_.water_is_transparent = water_is_transparent;
    build_.visibility = VisibilityKind::kNone;
    return base::Ok{};
  }

  base::Status update_visibility() {
    const StagePolicy policy = manager_.choose_visibility(leak_.has_value());
    if (policy == StagePolicy::kReuse) stages_.reuse("visibility");
    if (policy != StagePolicy::kBuild) return base::Ok{};
    has_new_visibility_ = true;
    return stages_.run("visibility", [&] {
      return make_visibility(manager_.wanted_visibility(), context_.jobs, context_.watcher, build_);
    });
  }

  base::Status update_light() {
    if (options_.light.world_keys.empty()) return update_light_as_the_level_says();
    TRY(formats::Entity worldspawn, override_world_keys(options_.light.world_keys, build_.bsp));
    const base::Status done = update_light_as_the_level_says();
    TRY_STATUS(restore_worldspawn(std::move(worldspawn), build_.bsp));
    return done;
  }

  // Call it once, after all stages.
  CompileReport finish() {
    // The level will be written now, so its visibility can no longer be lost. A state that stays belongs to
    // other portals.
    if (has_new_visibility_ && build_.visibility == VisibilityKind::kFull) build_.visibility_state.clear();
    return {std::move(leak_), stages_.take_times(), std::move(missing_textures_)};
  }

 private:
  base::Status update_light_as_the_level_says() {
    TRY(const StagePolicy policy, manager_.choose_light(options_.light));
    switch (policy) {
      case StagePolicy::kSkip:
        remove_light(build_);
        return base::Ok{};
      case StagePolicy::kReuse:
        if (build_.light_key == 0) return base::Ok{};  // no light, or another tool's
        stages_.reuse("light");
        return reuse_light(build_);
      case StagePolicy::kBuild:
        break;
    }
    return stages_.run("light", [&] {
      return make_light(options_.light, context_.jobs, progress_, build_, context_.warnings);
    });
  }

  CompileOptions options_;
  CompileContext context_;
  Build& build_;
  IncrementalBuild manager_;
  StageTimer stages_{context_.watcher};
  std::optional<LeakPath> leak_;
  bool has_new_visibility_ = false;
  std::vector<std::string> missing_textures_;
  // A member, since Progress only refers to it.
  struct StageProgress {
    CompileWatcher& watcher;
    bool operator()(std::size_t done, std::size_t total) const { return watcher.progress(done, total); }
  } progress_{context_.watcher};
};

}  // namespace

base::Result<CompileReport> compile_level(const LevelSource& source, const CompileOptions& options,
                                          const CompileContext& context, Build& io_build) {
  Pipeline pipeline(source.palette, options, context, io_build);
  const TextureSet textures = pipeline.load_textures(source);
  TRY_STATUS(pipeline.make_bsp(source.map, textures));
  TRY_STATUS(pipeline.update_visibility());
  TRY_STATUS(pipeline.update_light());
  if (!options.draft.half_life)
    warn_about_bytes({source.map, io_build.brush_entities}, io_build.bsp, context.warnings);
  return pipeline.finish();
}

base::Result<CompileReport> finish_level(const formats::Palette& palette, const CompileOptions& options,
                                         const CompileContext& context, Build& io_build) {
  Pipeline pipeline(palette, options, context, io_build);
  TRY_STATUS(pipeline.update_portals());
  TRY_STATUS(pipeline.update_visibility());
  TRY_STATUS(pipeline.update_light());
  return pipeline.finish();
}

}  // namespace temblor::compiler
