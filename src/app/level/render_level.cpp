#include "app/level/render_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/bench/frame_report.h"
#include "app/demo/film.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "app/level/level_loading.h"
#include "app/level/level_scene.h"
#include "app/level/running_level.h"
#include "app/level/scene_drawer.h"
#include "app/level/viewpoints.h"
#include "client/view/presentation.h"
#include "math/angles.h"
#include "render/settings.h"
#include "server/server_variables.h"

namespace temblor::app {
namespace {

world::SpawnRules read_spawn_rules(const server::ServerVariables& variables) {
  return {.skill = variables.skill(), .deathmatch = variables.kind(1) == server::GameKind::kDeathmatch};
}

bool is_from_above(const RenderOptions& options) {
  return options.projection == render::Projection::kOrthographic;
}

// Returns the camera of the first frame: as --pos and --angles say, otherwise at the start or above the
// level.
render::Camera make_first_camera(const RenderOptions& options, const world::Level& level,
                                 const Viewpoint& start) {
  const bool from_above = is_from_above(options);
  const Viewpoint viewpoint =
      from_above ? Viewpoint{"", level_center(level), math::Vec3(90.0f, 0.0f, 0.0f)} : start;
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

// A moment of a level without a camera.
class StillLevel {
 public:
  // Prints notes about the level. The arguments must outlive the result.
  static base::Result<std::unique_ptr<StillLevel>> make(const RenderOptions& options, const LoadedMap& loaded,
                                                        const host::HostVariables& settings);

  // Where a player stands at the start.
  const Viewpoint& start() const { return start_; }
  render::Scene see(const render::Camera& camera) const;

 private:
  StillLevel(const RenderOptions& options, const LoadedMap& loaded,
             const client::PresentationSettings& settings)
      : options_(options), loaded_(loaded), settings_(settings) {}
  void show_level(const world::SpawnRules& rules);
  base::Status show_running_level(const server::ServerVariables& rules);
  void apply_environment();

  const RenderOptions& options_;
  const LoadedMap& loaded_;
  client::PresentationSettings settings_;
  Viewpoint start_;
  // The scene refers to these; `running_` is null without --entities.
  LevelScene level_scene_;
  client::SceneEnvironment environment_;
  std::unique_ptr<RunningLevel> running_;
  render::Scene scene_;
};

base::Result<std::unique_ptr<StillLevel>> StillLevel::make(const RenderOptions& options,
                                                           const LoadedMap& loaded,
                                                           const host::HostVariables& settings) {
  std::unique_ptr<StillLevel> still(new StillLevel(options, loaded, settings.presentation()));
  still->settings_.view.fov_deg = options.frame.fov_deg;
  for (const std::string& note : loaded.notes) print_note(note);
  if (options.entities)
    TRY_STATUS(still->show_running_level(settings.server()));
  else
    still->show_level(read_spawn_rules(settings.server()));
  if (is_from_above(options)) {
    still->scene_.is_overview = true;
    still->scene_.fog = {};  // the camera is so far away that it would hide everything
  }
  return still;
}

// Doors and lifts are where the mapper placed them, and there is nothing that only game code creates.
void StillLevel::show_level(const world::SpawnRules& rules) {
  start_ = find_start_viewpoint(*loaded_.level, rules);
  level_scene_ = make_level_scene(loaded_.level, rules);
  scene_ = make_scene(level_scene_, {}, options_.time_s.value_or(0), settings_.choices.light_styles);
  apply_environment();
  client::apply_choices(settings_.choices, scene_);
}

void StillLevel::apply_environment() {
  environment_.begin_level(*loaded_.level);
  client::EnvironmentSettings settings = settings_.environment;
  const assets::Library no_files{vfs::FileSystem()};
  const std::string skybox = client::parse_environment(*loaded_.level).skybox;
  if (!loaded_.library && settings.skybox && !skybox.empty()) {
    settings.skybox = false;
    print_note(
        fmt::format("{}: the skybox {} is left out, because there is no game data; name the directory that "
                    "contains id1 with --basedir",
                    loaded_.level->name, skybox));
  }
  const client::Game no_messages;
  std::vector<std::string> notes;
  environment_.apply({loaded_.library ? *loaded_.library : no_files, no_messages, scene_.time_s}, settings,
                     notes, scene_);
  for (const std::string& note : notes) print_note(note);
}

// The level's own notes were printed when it was loaded.
base::Status StillLevel::show_running_level(const server::ServerVariables& rules) {
  TRY(running_, RunningLevel::start(loaded_, options_.program, rules, settings_));
  for (const std::string& note : running_->take_notes())
    if (std::ranges::find(loaded_.notes, note) == loaded_.notes.end()) print_note(note);
  scene_ = running_->scene();
  start_ = {"player", scene_.camera.origin_world, scene_.camera.angles_deg};
  if (options_.time_s) {
    scene_.time_s = *options_.time_s;
    scene_.light_styles =
        world::compute_light_styles(running_->light_styles(), scene_.time_s, settings_.choices.light_styles);
  }
  return base::Ok{};
}

// A camera in a liquid sees the picture that a player there would see.
render::Scene StillLevel::see(const render::Camera& camera) const {
  render::Scene scene = scene_;
  scene.camera = camera;
  scene.tint = {};
  scene.underwater = false;
  if (scene.is_overview) return scene;
  const client::PlayerView view = client::make_camera_view(camera, *scene.level, settings_.view);
  scene.tint = view.tint;
  scene.underwater = view.underwater && settings_.choices.warps_underwater;
  return scene;
}

}  // namespace

// The first frame may be later than 0, so the angle is computed from the frame's number.
base::Status render_level(const RenderOptions& options, const GameFolders& folders,
                          const host::HostVariables& settings) {
  TRY(const LoadedMap loaded, load_map(folders, options.map));
  TRY(const std::unique_ptr<StillLevel> still, StillLevel::make(options, loaded, settings));
  render::Camera camera = make_first_camera(options, *loaded.level, still->start());
  const render::Settings render_settings = settings.render();
  TRY(SceneDrawer drawer,
      SceneDrawer::make(options.frame.renderer, loaded.look.palette, loaded.look.colormap));
  render::FrameBuffer frame(options.frame.size.width, options.frame.size.height, options.frame.format);
  TRY(Film film,
      Film::open(options.out, {options.frame.size, options.frames_per_second}, loaded.look.palette));
  Progress progress("frames");
  const FrameRange frames = options.frame_range.value_or(FrameRange{0, 1});
  const float first_yaw_deg = camera.angles_deg.y;
  for (std::size_t i = frames.first; i < frames.end; ++i) {
    camera.angles_deg.y = first_yaw_deg + static_cast<float>(options.turn_deg * static_cast<double>(i));
    TRY(const render::FrameStats stats, drawer.draw(still->see(camera), render_settings, frame));
    TRY_STATUS(film.add(frame));
    if (options.stats) fmt::print("frame {}\n{}", i, describe_frame(stats, frame.pixel_count()));
    progress.update(i - frames.first + 1, frames.end - frames.first);
  }
  return film.finish();
}

}  // namespace temblor::app
