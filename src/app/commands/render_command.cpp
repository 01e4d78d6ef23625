#include "app/commands/render_command.h"

#include "app/commands/command_line.h"
#include "app/demo/film.h"
#include "app/demo/render_demo.h"
#include "app/level/render_level.h"
#include "client/view/presentation.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr const char* kRenderHelpFooter =
    R"(Without --pos and --angles, the camera shows a player's view at the start of the level, or with an
orthographic projection the whole level from above, without its ceilings and its sky.
`temblor --help` describes --basedir, --game, --set, and --show.

Examples:
  temblor render -o small_level.png
  temblor --basedir ~/quake render --map start -o start.png
  temblor --basedir ~/quake render --map e1m1 --pos 480,-352,110 --angles 10,90,0 --size 1920x1080 -o hall.png
  temblor --basedir ~/quake render --map e1m1 --entities --skill 2 -o hard.png
  temblor --basedir ~/quake render --map e1m1 --projection orthographic --size 2048x2048 -o plan.png
  temblor --basedir ~/quake --show mips render --map e1m1 --color indexed --stats -o mips.png
  temblor --basedir ~/quake render --map start --frames 360 --turn 1 -o turn.mp4
  temblor --basedir ~/quake render --demo demo1 --size 1920x1080 --fps 60 -o demo1.mp4
  temblor --basedir ~/quake render --demo demo1 --frames 300:360 -o demo1-%05d.png
  temblor --basedir ~/quake render --demo demo1 -o demo1.wav)";

// Parses the value of --projection.
base::Result<render::Projection> parse_projection(std::string_view text) {
  if (text == "perspective") return render::Projection::kPerspective;
  if (text == "orthographic") return render::Projection::kOrthographic;
  return base::error(ErrorCode::kUsage, "\"{}\" is neither perspective nor orthographic", text);
}

// Returns an error if the output does not fit the other options, before anything is loaded.
base::Status check_names(const RenderOptions& options) {
  TRY(const OutputKind kind, find_output_kind(options.out));
  const FrameRange frames =
      options.frame_range.value_or(FrameRange{0, options.demo.empty() ? 1 : kMaxFrames});
  if (kind == OutputKind::kPicture && frames.end - frames.first > 1)
    return base::error(ErrorCode::kUsage,
                       "-o {}: several frames need a number in the name, like turn-%05d.png, or a film, like "
                       "turn.mp4; or choose one "
                       "frame with --frames A:B",
                       options.out);
  if (kind == OutputKind::kSound && options.demo.empty())
    return base::error(ErrorCode::kUsage, "-o {}: only demos have sound; name one with --demo", options.out);
  if (kind == OutputKind::kSound && options.no_sound)
    return base::error(ErrorCode::kUsage, "-o {}: --nosound leaves nothing to write", options.out);
  return base::Ok{};
}

// --skill and --deathmatch are console variables, so that --set, too, can choose the entities.
base::Status apply_game_options(const RenderOptions& options, command::Variables& io_variables) {
  if (options.skill) TRY_STATUS(io_variables.set("skill", std::to_string(*options.skill)));
  if (options.deathmatch) TRY_STATUS(io_variables.set("deathmatch", "1"));
  return base::Ok{};
}

// Adds the options that say what is drawn.
void add_source_options(Command& command, RenderOptions& io_options) {
  const Option* map = command
                          .add_option("--map", io_options.map,
                                      "Level of the game, or a .bsp file (default: a small built-in level)")
                          ->type_name("NAME");
  const Option* demo = command.add_option("--demo", io_options.demo, "Demo of the game, or a .dem file")
                           ->type_name("NAME")
                           ->excludes(map);
  const Option* entities =
      command
          .add_flag("--entities", io_options.entities,
                    "Run the game for a second, and also draw monsters, items, torches, and "
                    "everything else that game code creates")
          ->needs(map)
          ->excludes(demo);
  command
      .add_option("--progs", io_options.program,
                  "Game code for --entities (default: progs.dat of the game directories)")
      ->type_name("FILE")
      ->needs(entities);
  command
      .add_option("--skill", io_options.skill, "Skill of the level: 0 easy, 1 normal, 2 hard, 3 nightmare")
      ->type_name("N")
      ->check(in_range(0, 3))
      ->default_str("1")
      ->excludes(demo);
  command
      .add_flag("--deathmatch", io_options.deathmatch,
                "Show the level of a deathmatch, not of a single player")
      ->excludes(demo);
}

}  // namespace

Command* add_render_command(Command& program, RenderOptions& io_options) {
  Command* command = program.add_subcommand("render", "Render pictures and films without a display");
  add_source_options(*command, io_options);
  add_parsed_option(*command, "--pos", io_options.position_world, parse_vec3, "Camera position")
      ->type_name("X,Y,Z");
  add_parsed_option(*command, "--angles", io_options.angles_deg, parse_vec3,
                    "Camera direction in degrees; positive pitch looks down")
      ->type_name("PITCH,YAW,ROLL");
  add_frame_options(*command, io_options.frame);
  add_renderer_option(*command, io_options.frame);
  add_parsed_option(*command, "--projection", io_options.projection, parse_projection,
                    "Perspective, or orthographic for a plan that fits the level")
      ->type_name("perspective|orthographic")
      ->default_str("perspective");
  command
      ->add_option("--time", io_options.time_s,
                   "Level time, for light styles, liquids, sky, and animated textures (default: 0, or with "
                   "--entities the game's)")
      ->type_name("SECONDS")
      ->check(in_range(0.0, 1e9));
  add_parsed_option(*command, "--frames", io_options.frame_range, parse_frame_range,
                    "Number of frames, or frames A to B-1 (default: one of a level, all of a demo)")
      ->type_name("N|A:B");
  command->add_option("--fps", io_options.frames_per_second, "Frames per second of a film")
      ->type_name("N")
      ->check(in_range(1, 1000))
      ->capture_default_str();
  command->add_option("--turn", io_options.turn_deg, "Turn the camera left between frames of a level")
      ->type_name("DEGREES");
  command->add_flag("--stats", io_options.stats, "Print counts and times of each frame");
  command->add_flag("--nosound", io_options.no_sound, "Make a silent film");
  command
      ->add_option("-o,--output", io_options.out,
                   "x.png, x-%05d.png (a picture per frame), x.mp4, x.y4m, or x.wav (a demo's sound)")
      ->type_name("FILE")
      ->required();
  command->footer(kRenderHelpFooter);
  return command;
}

base::Status run_render(const RenderOptions& options, const GameFolders& folders,
                        const host::HostVariables& settings) {
  TRY_STATUS(check_names(options));
  if (!options.demo.empty()) return render_demo(options, folders, settings.presentation(), settings.render());
  TRY_STATUS(apply_game_options(options, settings.variables()));
  return render_level(options, folders, settings);
}

}  // namespace temblor::app
