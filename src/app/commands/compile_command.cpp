#include "app/commands/compile_command.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <vector>

#include "app/commands/command_line.h"
#include "app/compile/compile_session.h"
#include "app/compile/compile_shards.h"
#include "app/compile/compile_summary.h"
#include "app/compile/texture_files.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "app/files/file_watch.h"
#include "app/files/game_files.h"

namespace temblor::app {
namespace {

constexpr const char* kCompileHelpFooter = R"(Examples:
  temblor --basedir quake compile maps/castle.map -o quake/id1/maps/castle.bsp
  temblor compile castle.map --wad wads --fast --watch
  temblor compile castle.map --textures art --extra 4
  temblor compile castle.bsp --only light
  temblor compile --textures art -o art.wad

Textures are looked for in --wad, then in what the map's "wad" key names. Without game data the palette is that of
Temblor's own game. Beside the level lies a .build file, with which the next run makes anew only what changed.)";

// Which stages run, when, and in which process.
void add_stage_options(Command& command, CompileCommandOptions& io_options) {
  add_parsed_option(command, "--only", io_options.only, parse_compile_stage,
                    "One stage: bsp, vis or light; of the others stays what still fits")
      ->type_name("STAGE");
  Option* const watch = command.add_flag("--watch", io_options.watch,
                                         "Compiles again whenever the map or a texture file is saved");
  Option* const shard = add_parsed_option(command, "--shard", io_options.shard, parse_shard,
                                          "With --only vis or light: does part K of N, for --merge");
  shard->type_name("K/N")->excludes(watch);
  command.add_flag("--merge", io_options.merge, "With --only vis or light: joins what the shards made")
      ->excludes(watch)
      ->excludes(shard);
  command.add_flag("--clean", io_options.clean, "Makes everything anew, and leaves no .build file");
}

base::Error usage(const char* what) {
  return base::error(base::ErrorCode::kUsage, "{}", what);
}

bool makes_wad(const CompileCommandOptions& options) {
  return options.source.empty() && !options.textures.empty() &&
         std::filesystem::path(options.out).extension() == ".wad";
}

base::Status check(const CompileCommandOptions& options) {
  if (options.source.empty() && !makes_wad(options))
    return usage("map is required; or --textures DIR -o NAME.wad, to make a WAD alone");
  const bool shared = options.shard || options.merge;
  const bool from_level = is_level(options.source);
  if (shared && (!options.only || *options.only == CompileStage::kBsp))
    return usage("--shard and --merge need --only vis or --only light");
  if (options.only && (options.no_vis || options.no_light))
    return usage("--only leaves stages as they are; it goes with neither --no-vis nor --no-light");
  if (shared && options.clean)
    return usage("--shard and --merge need the .build file that --clean does without");
  if (options.fast && shared) return usage("--fast leaves nothing to share out");
  if (from_level && (options.watch || options.only == CompileStage::kBsp))
    return usage("a .bsp has no brushes: --watch and --only bsp need the .map");
  if (from_level && (options.no_vis || options.bsp2 || options.built_mips || !options.wads.empty() ||
                     !options.textures.empty()))
    return usage(
        "a .bsp keeps its textures and format, and gets visibility: --no-vis, --bsp2, --build-mips, --wad "
        "and --textures need the .map");
  return base::Ok{};
}

base::Status write(CompileSession& io_session, const compiler::CompileReport& report, bool keep) {
  TRY_STATUS(write_level(io_session.build(), report.leak, io_session.paths(), keep));
  if (report.leak) print_leak(*report.leak, io_session.paths());
  return base::Ok{};
}

base::Status write_wad(const CompileCommandOptions& options, const GameFolders& folders) {
  TRY(const assets::Look look, find_look(folders));
  TRY(const base::ByteVector wad, wad_of_pictures(options.textures, look.palette));
  return replace_file(options.out, wad);
}

// Until it is interrupted. What goes wrong is told, and the next version of the map tried.
base::Status run_and_watch(const CompileCommandOptions& options, CompileSession& io_session) {
  FileWatch watch;
  for (;;) {
    base::Status done = base::Ok{};
    const base::Result<compiler::CompileReport> report = io_session.run();
    watch.add(io_session.source_files());
    if (report.ok())
      done = write(io_session, *report, !options.clean);
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
  Command* command = program.add_subcommand("compile", "Makes a level of an editor's .map");
  command
      ->add_option("map", io_options.source, "A .map file; or a .bsp, which gets visibility and light anew")
      ->type_name("MAP");
  command->add_option("-o,--output", io_options.out, "The level; else beside the map, .bsp")
      ->type_name("OUT");
  add_stage_options(*command, io_options);
  command
      ->add_option("--wad", io_options.wads,
                   "A WAD or .bsp with textures, or a folder of WADs; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--textures", io_options.textures,
                   "A folder of PNG files: textures that come before all others")
      ->type_name("DIR");
  command->add_flag("--fast", io_options.fast, "Rough visibility, light without dirt and bounces");
  command->add_flag("--no-vis", io_options.no_vis, "Leaves visibility out: everything is drawn");
  command->add_flag("--no-light", io_options.no_light, "Leaves light out: everything is bright");
  command->add_flag("--opaque-water", io_options.opaque_water,
                    "Nothing is seen through the surface of water");
  command->add_flag("--build-mips", io_options.built_mips, "Makes the smaller mip levels anew");
  command->add_flag("--bsp2", io_options.bsp2, "Writes BSP2 though the level fits the original's format");
  command->add_option("--extra", io_options.extra, "Samples of a shadow each way: 1, 2 or 4")
      ->type_name("N")
      ->check(one_of({1, 2, 4}));
  command->add_option("--bounce", io_options.bounces, "Bounces of light, whatever the map says")
      ->type_name("N")
      ->check(in_range(0, 16));
  command->add_option("--threads", io_options.threads, "Threads; 0: one for each core")
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
  TRY_STATUS(write(*session, report, !options.clean));
  print_summary(session->build(), report, session->paths());
  return base::Ok{};
}

}  // namespace temblor::app
