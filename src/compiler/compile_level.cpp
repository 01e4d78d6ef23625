#include "compiler/compile_level.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "base/hash.h"
#include "compiler/bsp/brushes/level_entities.h"
#include "compiler/bsp/tree_portals.h"
#include "compiler/build/build_keys.h"
#include "compiler/build/level_textures.h"
#include "compiler/light/build_light.h"
#include "compiler/vis/build_visibility.h"

namespace temblor::compiler {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Tells the watcher of stages, and keeps how long each takes.
class Stages {
 public:
  Stages(CompileWatcher& watcher, std::vector<StageTime>& out) : watcher_(watcher), out_(out) {}

  template <typename Stage>
  auto run(const char* name, const Stage& stage) {
    watcher_.begin_stage(name);
    const Clock::time_point start = Clock::now();
    auto result = stage();
    out_.push_back({name, seconds_since(start)});
    return result;
  }
  void keep(const char* name) { out_.push_back({name, std::nullopt}); }

 private:
  CompileWatcher& watcher_;
  std::vector<StageTime>& out_;
};

// As a reader of the file will see it: what is kept in memory and what a later run reads are the same.
base::Result<formats::Bsp> as_written(const formats::Bsp& bsp, bool bsp2) {
  base::Result<base::ByteVector> bytes =
      formats::write_bsp(bsp, bsp2 ? formats::BspVersion::kBsp2 : formats::BspVersion::k29);
  if (!bytes.ok() && !bsp2) bytes = formats::write_bsp(bsp, formats::BspVersion::kBsp2);
  TRY(const base::ByteVector written, std::move(bytes));
  return formats::read_bsp(written);
}

// With the pictures of its textures: a file knows no names without them.
base::Result<Build> build_of(Draft draft, const TextureSet& textures, const CompileOptions& options) {
  Build build;
  build.own_textures = draft.bsp.miptexes.size();
  build.water_is_transparent = options.draft.water_is_transparent;
  put_textures(textures, build.own_textures, draft.bsp);
  TRY(build.bsp, as_written(draft.bsp, options.bsp2));
  build.brush_entities = std::move(draft.brush_entities);
  build.portals = std::move(draft.portals);
  build.face_keys = {std::move(draft.surface_keys), std::move(draft.keys_of_face)};
  return build;
}

bool is_up_to_date(const Build& build, StageKey brushes_key, const formats::Map& map,
                   const CompileOptions& options) {
  if (build.bsp.models.empty() || build.brushes_key != brushes_key) return false;
  const auto brush_entities = std::ranges::count_if(
      map.entities, [](const formats::MapEntity& entity) { return !is_point_entity(entity); });
  if (static_cast<std::size_t>(brush_entities) != build.brush_entities.size()) return false;
  // What visibility wrote into leaves and models is not undone, but made without.
  if (options.visibility_wish == StagePolicy::kSkip && build.visibility != VisibilityKind::kNone)
    return false;
  return build.solid_occupants_key == key_of_solid_occupants(map, build.bsp);
}

base::Status make_brushes(const formats::Map& map, const TextureSet& textures, const CompileOptions& options,
                          base::Jobs& jobs, CompileWatcher& watcher, Stages& io_stages, Build& io_build,
                          CompileReport& io_report, Warnings& io_warnings) {
  const auto size = [&](std::string_view name) { return texture_size_of(textures, name); };
  const StageKey key = base::hash_with(key_of_brushes(map, size, options.draft), options.bsp2 ? 1 : 0);
  if (is_up_to_date(io_build, key, map, options)) {
    io_stages.keep("bsp");
    put_textures(textures, io_build.own_textures, io_build.bsp);
    io_build.bsp.entities = formats::write_entities(level_entities(map, io_build.brush_entities));
    return base::Ok{};
  }
  const auto progress = [&](std::size_t done, std::size_t total) { return watcher.progress(done, total); };
  TRY(DraftResult made, io_stages.run("bsp", [&] {
    return make_draft(map, size, options.draft, jobs, io_warnings, progress);
  }));
  TRY(Build build, build_of(std::move(made.draft), textures, options));
  build.visibility_state = std::move(io_build.visibility_state);
  build.light_cache = std::move(io_build.light_cache);
  io_build = std::move(build);
  if (!made.leak && !made.clip_hulls_leak && !made.is_region) {
    io_build.brushes_key = key;
    io_build.solid_occupants_key = key_of_solid_occupants(map, io_build.bsp);
  }
  io_report.leak = std::move(made.leak);
  return base::Ok{};
}

// Whether it was made.
base::Result<bool> bring_visibility(const CompileOptions& options, base::Jobs& jobs, CompileWatcher& watcher,
                                    bool leaks, Stages& io_stages, Build& io_build) {
  const VisibilityKind wanted = options.fast_visibility ? VisibilityKind::kRough : VisibilityKind::kFull;
  if (!leaks && options.visibility_wish == StagePolicy::kBuild && io_build.visibility != wanted) {
    TRY_STATUS(io_stages.run("visibility", [&] { return make_visibility(wanted, jobs, watcher, io_build); }));
    return true;
  }
  if (io_build.visibility != VisibilityKind::kNone) io_stages.keep("visibility");
  return false;
}

base::Status update_light(const formats::Palette& palette, const CompileOptions& options, base::Jobs& jobs,
                          CompileWatcher& watcher, Stages& io_stages, Build& io_build,
                          Warnings& io_warnings) {
  if (options.light_wish == StagePolicy::kSkip) {
    remove_light(io_build);
    return base::Ok{};
  }
  LightOptions how = options.light;
  how.palette = palette;
  TRY(const StageKey key, light_key_of(io_build, how));
  if (options.light_wish == StagePolicy::kReuse || key == io_build.light_key) {
    if (io_build.light_key == 0) return base::Ok{};  // none, or not ours
    io_stages.keep("light");
    return keep_light(io_build);
  }
  const auto progress = [&](std::size_t done, std::size_t total) { return watcher.progress(done, total); };
  return io_stages.run("light", [&] { return make_light(how, jobs, progress, io_build, io_warnings); });
}

base::Status finish(const formats::Palette& palette, const CompileOptions& options, base::Jobs& jobs,
                    CompileWatcher& watcher, bool leaks, Stages& io_stages, Build& io_build,
                    Warnings& io_warnings) {
  TRY(const bool has_new_visibility, bring_visibility(options, jobs, watcher, leaks, io_stages, io_build));
  TRY_STATUS(update_light(palette, options, jobs, watcher, io_stages, io_build, io_warnings));
  // Only now is it in a level that will be written. A state that is still there is of other portals.
  if (has_new_visibility && io_build.visibility == VisibilityKind::kFull) io_build.visibility_state.clear();
  return base::Ok{};
}

}  // namespace

base::Result<CompileReport> compile_level(const formats::Map& map, std::span<const TextureSource> sources,
                                          const formats::Palette& palette, const CompileOptions& options,
                                          base::Jobs& jobs, CompileWatcher& watcher, Build& io_build,
                                          Warnings& io_warnings) {
  CompileReport report;
  Stages stages(watcher, report.times);
  const TextureSet textures = stages.run("textures", [&] {
    return make_texture_set(texture_names(map), sources, palette, options.mip_levels, io_warnings);
  });
  TRY_STATUS(make_brushes(map, textures, options, jobs, watcher, stages, io_build, report, io_warnings));
  TRY_STATUS(finish(palette, options, jobs, watcher, report.leak.has_value(), stages, io_build, io_warnings));
  return report;
}

base::Result<Build> build_of_level(formats::Bsp bsp, std::optional<formats::Lit> lit,
                                   bool water_is_transparent) {
  Build build;
  TRY(const std::vector<formats::Entity> entities, formats::read_entities(bsp.entities));
  TRY(build.portals, make_tree_portals(bsp, {water_is_transparent, Clusters::kSharedVisibility}));
  build.face_keys = face_keys_of(bsp, entities);
  build.own_textures = bsp.miptexes.size();
  build.water_is_transparent = water_is_transparent;
  build.bsp = std::move(bsp);
  build.lit = std::move(lit);
  return build;
}

base::Result<CompileReport> finish_level(const formats::Palette& palette, const CompileOptions& options,
                                         base::Jobs& jobs, CompileWatcher& watcher, Build& io_build,
                                         Warnings& io_warnings) {
  CompileReport report;
  Stages stages(watcher, report.times);
  if (const bool water = options.draft.water_is_transparent; water != io_build.water_is_transparent) {
    TRY(io_build.portals, make_tree_portals(io_build.bsp, {water, Clusters::kSharedVisibility}));
    io_build.water_is_transparent = water;
    io_build.visibility = VisibilityKind::kNone;
  }
  TRY_STATUS(finish(palette, options, jobs, watcher, false, stages, io_build, io_warnings));
  return report;
}

}  // namespace temblor::compiler
