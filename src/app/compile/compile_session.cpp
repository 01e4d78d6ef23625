#include "app/compile/compile_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "app/compile/change_map.h"
#include "app/compile/compile_summary.h"
#include "app/compile/texture_files.h"
#include "app/files/diagnostics.h"
#include "app/files/game_files.h"
#include "app/files/progress.h"
#include "base/text.h"
#include "compiler/compile_options.h"
#include "compiler/portal_file.h"
#include "compiler/prefabs.h"
#include "formats/bspx/light_directions.h"
#include "formats/levels/lit.h"
#include "formats/levels/prt.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;
using compiler::StagePolicy;

// Shows a progress line for each stage. Defers Ctrl-C during visibility, which can be saved and resumed.
class TerminalWatcher : public compiler::CompileWatcher {
 public:
  TerminalWatcher(Interrupt& interrupt, const LevelPaths& paths, bool saves)
      : interrupt_(interrupt), paths_(paths), saves_(saves) {}
  ~TerminalWatcher() override { interrupt_.stop_deferring(); }

  void begin_stage(const char* name) override {
    progress_.emplace(name);
    if (std::string_view(name) == "visibility")
      interrupt_.defer();
    else
      interrupt_.stop_deferring();
  }
  bool progress(std::size_t done, std::size_t total) override {
    progress_->update(done, total);
    return !interrupt_.was_requested();
  }
  // Called every now and then during visibility. A failure is only a note, because the run itself can go on.
  void save(base::Bytes visibility_state) override {
    if (!saves_) return;
    if (const base::Status saved = write_partial_visibility(visibility_state, paths_); !saved.ok())
      print_note(fmt::format("cannot save the unfinished visibility: {}", saved.error().message()));
  }
  void finish() { progress_.reset(); }

 private:
  Interrupt& interrupt_;
  const LevelPaths& paths_;
  bool saves_;
  std::optional<Progress> progress_;
};

// Translates the options of the command to those of the compiler. With --only, the other stages keep their
// results.
compiler::CompileOptions make_compile_options(const CompileCommandOptions& options) {
  const auto choose_policy = [&](CompileStage stage, bool is_skipped) {
    if (is_skipped) return StagePolicy::kSkip;
    return !options.only || *options.only == stage ? StagePolicy::kBuild : StagePolicy::kReuse;
  };
  compiler::CompileOptions how;
  how.visibility_policy = choose_policy(CompileStage::kVisibility, options.no_vis);
  how.light_policy = choose_policy(CompileStage::kLight, options.no_light);
  how.draft.water_is_transparent = !options.opaque_water;
  how.draft.clip_hulls = !options.no_clip;
  how.draft.fill_outside = !options.no_fill;
  if (options.subdivide_texels) how.draft.subdivide_texels = *options.subdivide_texels;
  how.fast_visibility = options.fast;
  how.light.fast = options.fast;
  how.light.extra = options.extra;
  how.light.soft = options.soft;
  how.light.bounces = options.bounces;
  how.light.world_keys = options.light_keys;
  if (options.sky_rays) how.light.sky_rays = *options.sky_rays;
  how.light.luxel_texels = options.luxel_texels;
  if (options.units_per_luxel) how.light.units_per_luxel = static_cast<float>(*options.units_per_luxel);
  if (options.light_grid) how.light.grid_step = options.light_grid_dist;
  how.mip_levels = options.built_mips ? compiler::MipLevels::kBuilt : compiler::MipLevels::kFromSource;
  how.bsp2 = options.bsp2;
  how.psb2 = options.psb2;
  how.draft.brush_list = options.brush_list;
  how.light.hdr = options.hdr;
  how.light.face_normals = options.face_normals;
  how.light.directions = options.directions;
  how.draft.half_life = options.hlbsp;
  return how;
}

// Reads a map and the maps that it includes (misc_external_map). `io_files` receives a stamp of every file.
base::Result<formats::Map> read_map_file(const std::string& path, std::vector<FileStamp>& io_files,
                                         compiler::Warnings& io_warnings) {
  const auto read = [&](const fs::path& file) -> base::Result<std::string> {
    io_files.push_back(read_file_stamp(file));
    TRY(const base::ByteVector bytes, vfs::read_disk_file(file));
    return std::string(base::as_text(bytes));
  };
  TRY(const std::string text, read(path));
  TRY(formats::Map map, formats::read_map(text).with_file(path));
  return compiler::expand_prefabs(std::move(map), path, read, io_warnings).with_file(path);
}

// Replaces the portals of a build by those of the portal file beside the level, if there is one that fits.
base::Status take_portal_file(const fs::path& path, compiler::Build& io_build) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return base::Ok{};
  TRY(const base::ByteVector bytes, vfs::read_disk_file(path));
  TRY(const formats::PortalFile file, formats::read_prt(base::as_text(bytes)).with_file(path.string()));
  TRY(io_build.portals, compiler::match_portal_file(file, io_build.bsp).with_file(path.string()));
  return base::Ok{};
}

// Makes a build from a compiled level, for a .bsp without a .build file.
base::Result<compiler::Build> read_level_build(const fs::path& bsp_path, bool water_is_transparent) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(bsp_path));
  TRY(formats::Bsp bsp, formats::read_bsp(bytes).with_file(bsp_path.string()));
  if (!bsp.repairs.empty()) print_note(fmt::format("{}: {}", bsp_path.string(), bsp.repairs));
  std::optional<formats::Lit> lit;
  const fs::path lit_path = make_level_paths(bsp_path).lit;
  if (const auto lit_bytes = vfs::read_disk_file(lit_path); lit_bytes.ok()) {
    TRY(lit, formats::read_lit(*lit_bytes).with_file(lit_path.string()));
  }
  if (bsp.find_bspx(formats::kLightDirectionsLump) == nullptr) {
    const fs::path lux_path = make_level_paths(bsp_path).lux;
    if (const auto lux_bytes = vfs::read_disk_file(lux_path); lux_bytes.ok()) {
      TRY(const auto directions, formats::read_lux(*lux_bytes).with_file(lux_path.string()));
      if (directions.size() == 3 * bsp.lighting.size()) formats::set_light_directions(directions, bsp);
    }
  }
  return compiler::make_build_from_level(std::move(bsp), std::move(lit), water_is_transparent)
      .with_file(bsp_path.string());
}

// Returns whether both paths name the same file, also through links.
bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code failure;
  return a == b || (fs::equivalent(a, b, failure) && !failure);
}

// Checks that the level overwrites neither the map nor one of its own side files.
base::Status check_output(const fs::path& source, const LevelPaths& paths) {
  if (!is_level(source) && is_same_file(source, paths.bsp))
    return base::Error{base::ErrorCode::kUsage,
                       "would overwrite the map; choose another name with -o NAME.bsp", paths.bsp.string()};
  for (const fs::path& beside :
       {paths.lit, paths.lux, paths.points, paths.portals, paths.build, paths.visibility})
    if (beside == paths.bsp)
      return base::Error{base::ErrorCode::kUsage,
                         "is the name of a file beside the level; choose another name with -o NAME.bsp",
                         paths.bsp.string()};
  return base::Ok{};
}

fs::path choose_output(const CompileCommandOptions& options) {
  if (!options.out.empty()) return options.out;
  return is_level(options.source) ? fs::path(options.source)
                                  : fs::path(options.source).replace_extension(".bsp");
}

int choose_thread_count(const CompileCommandOptions& options) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return options.threads.value_or(0) == 0 ? cores : *options.threads;
}

}  // namespace

bool is_level(const fs::path& source) {
  return base::to_lower(source.extension().string()) == ".bsp";
}

CompileSession::CompileSession(const CompileCommandOptions& options, formats::Palette palette,
                               LevelPaths paths)
    : options_(options), palette_(palette), paths_(std::move(paths)), jobs_(choose_thread_count(options)) {}

// Checks everything that is cheap to check, so that a long compilation does not fail at its end.
base::Result<std::unique_ptr<CompileSession>> CompileSession::begin(const CompileCommandOptions& options,
                                                                    const GameFolders& folders) {
  TRY(const formats::Palette palette, find_palette(folders));
  const LevelPaths paths = make_level_paths(choose_output(options));
  TRY_STATUS(check_output(options.source, paths));
  if (make_compile_options(options).light_policy == StagePolicy::kBuild) TRY_STATUS(compiler::check_light());
  std::unique_ptr<CompileSession> session(new CompileSession(options, palette, paths));
  session->game_wads_ = list_game_wads(folders);
  // If a .bsp is compiled to another file, that file's build does not belong to it.
  const bool is_its_own_source = !is_level(options.source) || is_same_file(options.source, paths.bsp);
  if (!options.clean && is_its_own_source) session->build_ = read_build_file(session->paths_);
  return session;
}

base::Result<compiler::CompileReport> CompileSession::run() {
  return run(make_compile_options(options_));
}

base::Result<compiler::CompileReport> CompileSession::run_bsp() {
  compiler::CompileOptions how = make_compile_options(options_);
  how.visibility_policy = how.light_policy = StagePolicy::kReuse;
  return run(how);
}

base::Result<compiler::CompileReport> CompileSession::run(const compiler::CompileOptions& how) {
  // Print warnings even if a stage fails, because they may explain why.
  warnings_.clear();
  TerminalWatcher watcher(interrupt_, paths_, !options_.clean);
  source_files_.clear();
  if (options_.clean) build_ = {};
  const auto stages = [&]() -> base::Result<compiler::CompileReport> {
    if (!is_level(options_.source)) return run_map(how, watcher, warnings_);
    if (build_.bsp.models.empty()) {
      // Keep the state of an interrupted visibility stage, which comes from its own file.
      base::ByteVector begun = std::move(build_.visibility_state);
      TRY(build_, read_level_build(options_.source, how.draft.water_is_transparent));
      build_.visibility_state = std::move(begun);
      if (options_.keeps_portals)
        if (const base::Status taken = take_portal_file(make_level_paths(options_.source).portals, build_);
            !taken.ok())
          print_note(fmt::format("{}; the portals are made from the level", taken.error().message()));
    }
    compiler::CompileOptions fitting = how;
    if (options_.keeps_portals) fitting.draft.water_is_transparent = build_.water_is_transparent;
    return compiler::finish_level(palette_, fitting, {jobs_, watcher, warnings_}, build_);
  };
  base::Result<compiler::CompileReport> report = stages();
  watcher.finish();
  print_warnings(warnings_);
  if (!report.ok() && interrupt_.was_requested()) {
    if (options_.clean || build_.visibility_state.empty())
      return base::Error{base::ErrorCode::kIo, "interrupted", options_.source};
    TRY_STATUS(write_partial_visibility(build_.visibility_state, paths_));
    return base::Error{base::ErrorCode::kIo, "interrupted; the next run resumes visibility", options_.source};
  }
  return std::move(report).with_file(options_.source);
}

base::Result<compiler::CompileReport> CompileSession::run_map(const compiler::CompileOptions& how,
                                                              compiler::CompileWatcher& watcher,
                                                              compiler::Warnings& io_warnings) {
  TRY(formats::Map map, read_map_file(options_.source, source_files_, io_warnings));
  change_map(options_, map);
  TRY(const TextureFiles textures,
      find_textures({options_.textures, options_.wads, game_wads_, options_.wad_option}, options_.source, map,
                    palette_, source_files_, io_warnings));
  return compiler::compile_level({map, textures.sources, palette_}, how, {jobs_, watcher, io_warnings},
                                 build_);
}

compiler::LightOptions CompileSession::light_options() const {
  compiler::LightOptions how = make_compile_options(options_).light;
  how.palette = palette_;
  return how;
}

}  // namespace temblor::app
