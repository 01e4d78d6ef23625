#include "app/commands/render_command.h"

#include "app/bench/frame_report.h"
#include "app/bench/viewpoints.h"
#include "app/commands/command_line.h"
#include "app/demo/film.h"
#include "app/demo/render_demo.h"
#include "app/files/diagnostics.h"
#include "app/files/level_loading.h"
#include "app/files/level_scene.h"
#include "app/files/progress.h"
#include "math/angles.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr const char* kRenderHelpFooter =
    R"(Without --pos and --angles, the camera shows a player's view at the start of the level, or with an
orthographic projection the whole level from above.
`temblor --help` describes --basedir, --game, --set, and --show.

Examples:
  temblor render -o small_level.png
  temblor --basedir ~/quake render --map start -o start.png
  temblor --basedir ~/quake render --map e1m1 --pos 480,-352,110 --angles 10,90,0 --size 1920x1080 -o hall.png
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

// Returns the camera of the first frame: as --pos and --angles say, otherwise at the level's start or above
// it.
render::Camera make_first_camera(const RenderOptions& options, const world::Level& level) {
  const bool from_above = options.projection == render::Projection::kOrthographic;
  const Viewpoint viewpoint = from_above ? Viewpoint{"", level_center(level), math::Vec3(90.0f, 0.0f, 0.0f)}
                                         : find_start_viewpoint(level);
  render::Camera camera;
  camera.angles_deg = options.angles_deg.value_or(viewpoint.angles_deg);
  // An orthographic camera sees the same area at any distance, so move it back by the level's diagonal, until
  // everything is in front of it.
  const math::Vec3 back(from_above
                            ? math::basis_from_angles(camera.angles_deg).forward * level_diagonal(level)
                            : math::Vec3d(0.0));
  camera.origin_world = options.position_world.value_or(viewpoint.eye_world - back);
  camera.fov_deg = options.frame.fov_deg;
  camera.projection = options.projection;
  return camera;
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

// Renders the frames of a level, whose camera turns by --turn from one frame to the next. The first frame may
// be later than 0, so the angle is computed from the frame's number.
base::Status render_map(const RenderOptions& options, const GameFolders& folders,
                        const render::Settings& settings) {
  TRY(const LoadedMap loaded, load_map(folders, options.map));
  for (const std::string& note : loaded.notes) print_note(note);
  const LevelScene level_scene = make_level_scene(loaded.level);
  render::Camera camera = make_first_camera(options, *loaded.level);
  render::Renderer renderer(loaded.look.palette, loaded.look.colormap);
  render::FrameBuffer frame(options.frame.size.width, options.frame.size.height, options.frame.format);
  TRY(Film film,
      Film::open(options.out, {options.frame.size, options.frames_per_second}, loaded.look.palette));
  Progress progress("frames");
  const FrameRange frames = options.frame_range.value_or(FrameRange{0, 1});
  const float first_yaw_deg = camera.angles_deg.y;
  for (std::size_t i = frames.first; i < frames.end; ++i) {
    camera.angles_deg.y = first_yaw_deg + static_cast<float>(options.turn_deg * static_cast<double>(i));
    const render::FrameStats stats =
        renderer.render(make_scene(level_scene, camera, options.time_s), settings, frame);
    TRY_STATUS(film.add(frame));
    if (options.stats) fmt::print("frame {}\n{}", i, describe_frame(stats, frame.pixel_count()));
    progress.update(i - frames.first + 1, frames.end - frames.first);
  }
  return film.finish();
}

}  // namespace

Command* add_render_command(Command& program, RenderOptions& io_options) {
  Command* command = program.add_subcommand("render", "Render pictures and films without a display");
  command
      ->add_option("--map", io_options.map,
                   "Level of the game, or a .bsp file (default: a small built-in level)")
      ->type_name("NAME");
  command->add_option("--demo", io_options.demo, "Demo of the game, or a .dem file")
      ->type_name("NAME")
      ->excludes("--map");
  add_parsed_option(*command, "--pos", io_options.position_world, parse_vec3, "Camera position")
      ->type_name("X,Y,Z");
  add_parsed_option(*command, "--angles", io_options.angles_deg, parse_vec3,
                    "Camera direction in degrees; positive pitch looks down")
      ->type_name("PITCH,YAW,ROLL");
  add_frame_options(*command, io_options.frame);
  add_parsed_option(*command, "--projection", io_options.projection, parse_projection,
                    "Perspective, or orthographic for a plan that fits the level")
      ->type_name("perspective|orthographic")
      ->default_str("perspective");
  command
      ->add_option("--time", io_options.time_s,
                   "Level time, for light styles, liquids, sky, and animated textures")
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
                        const client::PresentationSettings& presentation, const render::Settings& settings) {
  TRY_STATUS(check_names(options));
  if (!options.demo.empty()) return render_demo(options, folders, presentation, settings);
  return render_map(options, folders, settings);
}

}  // namespace temblor::app
