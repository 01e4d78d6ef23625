#include "app/commands/compile_command.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <vector>

#include "app/commands/command_line.h"
#include "app/compile/compile_session.h"
#include "app/compile/compile_shards.h"
#include "app/compile/compile_summary.h"
#include "app/compile/report/level_report.h"
#include "app/compile/texture_files.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "app/files/file_watch.h"
#include "app/files/game_files.h"
#include "base/text.h"

namespace temblor::app {
namespace {

constexpr const char* kCompileHelpFooter =
    R"(Textures come from --textures, then --wad, then the WADs in the map's "wad" key. The .build file beside
the level lets the next run rebuild only what changed. docs/compiling.md describes the compiler and the keys
that it reads.

Examples:
  temblor --basedir ~/quake compile castle.map -o ~/quake/id1/maps/castle.bsp
  temblor compile castle.map --fast --watch
  temblor compile castle.map --wad wads --extra 4
  temblor compile castle.map --report castle.html
  temblor compile castle.bsp --only light
  temblor compile --textures art -o art.wad)";

// Adds the options that choose which stages run, when, and in which process.
void add_stage_options(Command& command, CompileCommandOptions& io_options) {
  add_parsed_option(command, "--only", io_options.only, parse_compile_stage,
                    "Run one stage; keep the results of the others that are still valid")
      ->type_name("bsp|vis|light");
  Option* const watch = command.add_flag(
      "--watch", io_options.watch, "Compile again whenever the map, a prefab, or a texture file is saved");
  Option* const shard = add_parsed_option(command, "--shard", io_options.shard, parse_shard,
                                          "With --only vis or light: compute part K of N, for --merge");
  shard->type_name("K/N")->excludes(watch);
  command.add_flag("--merge", io_options.merge, "With --only vis or light: merge the results of all shards")
      ->excludes(watch)
      ->excludes(shard);
  command.add_flag("--clean", io_options.clean, "Rebuild everything; write no .build file");
}

base::Error usage_error(const char* what) {
  return base::error(base::ErrorCode::kUsage, "{}", what);
}

// Returns whether the command makes only a WAD from PNG files, without a map.
bool makes_wad(const CompileCommandOptions& options) {
  return options.source.empty() && !options.textures.empty() &&
         std::filesystem::path(options.out).extension() == ".wad";
}

bool is_html(const std::filesystem::path& file) {
  const std::string ending = base::to_lower(file.extension().string());
  return ending == ".html" || ending == ".htm";
}

// Returns an error for options that contradict each other, before any file is read.
base::Status check(const CompileCommandOptions& options) {
  if (options.source.empty() && !makes_wad(options))
    return usage_error("no map given (to make only a WAD, use --textures DIR -o NAME.wad)");
  // Whether this run is one of several that share a stage.
  const bool shared = options.shard || options.merge;
  const bool from_level = is_level(options.source);
  if (shared && (!options.only || *options.only == CompileStage::kBsp))
    return usage_error("--shard and --merge need --only vis or --only light");
  if (options.only && (options.no_vis || options.no_light))
    return usage_error("--only cannot be combined with --no-vis or --no-light");
  if (shared && options.clean)
    return usage_error("--shard and --merge need the .build file, which --clean does not write");
  if (options.fast && shared) return usage_error("--shard and --merge cannot be combined with --fast");
  if (from_level && (options.watch || options.only == CompileStage::kBsp))
    return usage_error("a .bsp has no brushes: --watch and --only bsp need the .map");
  if (from_level && (options.no_vis || options.bsp2 || options.psb2 || options.hlbsp || options.brush_list ||
                     options.built_mips || !options.wads.empty() || !options.textures.empty()))
    return usage_error(
        "--no-vis, --bsp2, --2psb, --hlbsp, --brushlist, --build-mips, --wad, and --textures need the .map; "
        "a "
        ".bsp keeps its textures and format");
  if (!options.report.empty() && !is_html(options.report))
    return usage_error("--report needs a name that ends in .html");
  if (!options.report.empty() && shared)
    return usage_error("--report cannot be combined with --shard or --merge");
  if (options.bsp2 + options.psb2 + options.hlbsp > 1)
    return usage_error("--bsp2, --2psb, and --hlbsp cannot be combined");
  return base::Ok{};
}

// Writes the HTML page about the level, which has been written.
base::Status write_report(const std::filesystem::path& file, CompileSession& io_session,
                          const compiler::CompileReport& report) {
  const std::filesystem::path& level = io_session.paths().bsp;
  std::error_code ignored;
  TRY(const std::string page,
      make_level_report({io_session.build(), report, io_session.warnings(), io_session.palette(),
                         level.filename().string(), std::filesystem::file_size(level, ignored)}));
  return replace_file(file, base::as_bytes(page));
}

// Writes the level and its report, and prints where it leaks.
base::Status write(const CompileCommandOptions& options, CompileSession& io_session,
                   const compiler::CompileReport& report) {
  std::optional<compiler::LeakPath> leak = report.leak;
  if (leak && options.leak_step > 0) leak->points_world = space_points(leak->points_world, options.leak_step);
  TRY_STATUS(write_level(io_session.build(), leak, io_session.paths(),
                         {.build = !options.clean,
                          .portals = options.portals,
                          .leak = !is_level(options.source),
                          .lit = options.force_lit}));
  if (!options.report.empty()) TRY_STATUS(write_report(options.report, io_session, report));
  if (!leak) return base::Ok{};
  if (options.leak_is_error)
    return base::Error{base::ErrorCode::kMalformed, describe_leak(*leak), options.source};
  print_leak(*leak, io_session.paths());
  return base::Ok{};
}

// Makes a WAD from PNG files, in the colors of the game's palette.
base::Status write_wad(const CompileCommandOptions& options, const GameFolders& folders) {
  TRY(const formats::Palette palette, find_palette(folders));
  TRY(const base::ByteVector wad, make_wad_from_pictures(options.textures, palette));
  return replace_file(options.out, wad);
}

// Compiles after every change until Ctrl-C. Prints errors and waits for the next version of the map.
base::Status run_and_watch(const CompileCommandOptions& options, CompileSession& io_session) {
  // run() stamps each file before it reads it, so a save during the compilation triggers the next one.
  FileWatch watch;
  for (;;) {
    base::Status done = base::Ok{};
    const base::Result<compiler::CompileReport> report = io_session.run();
    watch.add(io_session.source_files());
    if (report.ok())
      done = write(options, io_session, *report);
    else
      done = report.error();
    if (io_session.was_interrupted()) return done;
    if (done.ok())
      print_times(*report, io_session.paths());
    else
      print_error(done.error());
    watch.wait();
  }
}

}  // namespace

Command* add_compile_command(Command& program, CompileCommandOptions& io_options) {
  Command* command = program.add_subcommand("compile", "Compile a .map to a level");
  command
      ->add_option("map", io_options.source, "Map to compile; or a .bsp, which gets new visibility and light")
      ->type_name("FILE");
  command->add_option("-o,--output", io_options.out, "Level to write (default: the map's name with .bsp)")
      ->type_name("FILE");
  command
      ->add_option("--report", io_options.report,
                   "HTML page to write: times, limits, leaks, visibility, light, and textures")
      ->type_name("FILE.html");
  add_stage_options(*command, io_options);
  command
      ->add_option("--wad", io_options.wads,
                   "WAD or .bsp with textures, or a folder to search for the map's WADs; repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--textures", io_options.textures,
                   "Folder of PNG files that become textures and precede all others")
      ->type_name("DIR");
  command->add_flag("--fast", io_options.fast, "Rough visibility; light without dirt and bounces");
  command->add_flag("--no-vis", io_options.no_vis, "Skip visibility: everything is drawn");
  command->add_flag("--no-light", io_options.no_light, "Skip light: everything is bright");
  command->add_flag("--opaque-water", io_options.opaque_water,
                    "Liquids block visibility, for games that draw them opaque");
  command->add_flag("--build-mips", io_options.built_mips, "Rebuild the smaller mip levels of WAD textures");
  command->add_flag("--bsp2", io_options.bsp2,
                    "Always write BSP2, even if the level fits the original format");
  command->add_flag("--2psb", io_options.psb2, "Write 2PSB, an older format for large levels");
  command->add_flag("--brushlist", io_options.brush_list,
                    "Write all brushes, with which newer engines let boxes of any size collide");
  command->add_flag("--facenormals", io_options.face_normals,
                    "Write the normals of smooth faces (_phong), for dynamic lights");
  command->add_flag("--hdr", io_options.hdr, "Write light without an upper limit too, for newer engines");
  command->add_flag("--lux", io_options.directions,
                    "Write the directions of light (.lux and in the level), for bumps in newer engines");
  command->add_flag("--hlbsp", io_options.hlbsp, "Write version 30, for Half-Life and its clip hulls");
  command->add_flag("--prt", io_options.portals, "Also write the portals, for other visibility programs");
  command->add_option("--extra", io_options.extra, "Light samples in each direction: 1, 2, or 4")
      ->type_name("N")
      ->check(one_of({1, 2, 4}));
  command
      ->add_option("--soft", io_options.soft,
                   "Average the light of this many samples on each side, to smooth shadows")
      ->type_name("N")
      ->check(in_range(0, 16));
  command->add_option("--bounce", io_options.bounces, "Light bounces, instead of the map's value")
      ->type_name("N")
      ->check(in_range(0, 16));
  command
      ->add_option("--lmscale", io_options.luxel_texels,
                   "Texels between light samples for newer engines, instead of the map's _lmscale")
      ->type_name("N")
      ->check(one_of({1, 2, 4, 8, 16, 32, 64, 128}));
  command
      ->add_option("--world-units-per-luxel", io_options.units_per_luxel,
                   "Units between light samples, whatever the textures; 0: off")
      ->type_name("N")
      ->check(in_range(0.0, 1024.0));
  Option* const grid = command->add_flag("--lightgrid", io_options.light_grid,
                                         "Write a grid of light, by which engines light models");
  add_parsed_option(*command, "--lightgrid-dist", io_options.light_grid_dist, parse_grid_dist,
                    "Units between its samples (default: 32,32,32)")
      ->type_name("X,Y,Z")
      ->needs(grid);
  command->add_option("--threads", io_options.threads, "Threads; 0: one per core")
      ->type_name("N")
      ->check(in_range(0, 256));
  command->footer(kCompileHelpFooter);
  return command;
}

base::Status run_compile(const CompileCommandOptions& options, const GameFolders& folders) {
  TRY_STATUS(check(options));
  if (makes_wad(options)) return write_wad(options, folders);
  TRY(const std::unique_ptr<CompileSession> session, CompileSession::begin(options, folders));
  if (options.watch) return run_and_watch(options, *session);
  if (options.shard) return run_shard(*options.only, *options.shard, *session);
  if (options.merge) return merge_shards(*options.only, *session);
  TRY(const compiler::CompileReport report, session->run());
  TRY_STATUS(write(options, *session, report));
  if (!options.quiet) print_summary(session->build(), report, session->paths());
  return base::Ok{};
}

}  // namespace temblor::app
