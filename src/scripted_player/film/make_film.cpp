#include "scripted_player/film/make_film.h"

#include <utility>
#include <vector>

#include "scripted_player/film/film_writer.h"
#include "scripted_player/session/run.h"

namespace temblor::player {
namespace {

// The level's time is ahead of the run's. So a run with this limit has all shots.
constexpr double kSpare_s = 1;

// The camera of a scene, asked once per tick.
class Director {
 public:
  explicit Director(const FilmScene& scene) {
    for (const Shot& shot : scene.shots)
      if (shot.is_flight()) flights_.emplace_back(&shot, CameraPath(shot));
  }

  // Returns the camera's place in the tick that ends at this time, and notes the pose. A flight takes a tick
  // more at both ends, because the server rounds its time.
  std::optional<math::Vec3> place_camera(double time_s, const math::Vec3& player_world) {
    for (auto& [shot, path] : flights_) {
      if (time_s < shot->begin_s - kTick_s || time_s >= shot->end_s + kTick_s) continue;
      const CameraPose pose = path.advance(time_s, player_world);
      poses_[static_cast<float>(time_s)] = pose;
      return pose.place_world;
    }
    return std::nullopt;
  }

  const CameraPoses& poses() const { return poses_; }

 private:
  std::vector<std::pair<const Shot*, CameraPath>> flights_;
  CameraPoses poses_;
};

}  // namespace

base::Result<Film> make_film(const FilmScript& script, const std::filesystem::path& base_folder) {
  FilmWriter writer(script);
  for (const FilmScene& scene : script.scenes) {
    Director director(scene);
    RunSetup setup;
    setup.session = {.base_folder = base_folder,
                     .games = {},
                     .map = scene.map,
                     .skill = scene.skill,
                     .seed = scene.seed,
                     .bots = scene.bots,
                     .can_cheat = scene.has_god,
                     .records = true,
                     .protocol = "999"};
    setup.has_god = scene.has_god;
    setup.visits_stops = scene.visits_stops;
    setup.limit_s = scene.shots.back().end_s + kSpare_s;
    setup.place_camera = [&](double time_s, const math::Vec3& player_world) {
      return director.place_camera(time_s, player_world);
    };
    TRY(const RunReport report, play_level(setup));
    if (!report.errors.empty()) return base::malformed("{}: {}", scene.map, report.errors.front());
    TRY_STATUS(writer.add(scene, report.demo, director.poses()).with_file(scene.map));
  }
  const double length_s = writer.length_s();
  return Film{std::move(writer).finish(), length_s};
}

}  // namespace temblor::player
