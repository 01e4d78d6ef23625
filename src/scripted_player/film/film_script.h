// Film scripts: text that lists the scenes and shots of a film (README.md, "Films").
//
//   film track=4 title=progs/title.spr
//   scene t1 seed=3 skill=2            a game of the scripted player
//     eyes 12 16.5                     the player's own view, from 12 s to 16.5 s of the level's time
//     camera 20 25                     a flight
//       title 688,600,300 yaw=270      the title hangs at this place
//       at 20 688,140,260 look=688,900,280
//       at 25 688,400,300 look=player
//   scene tdm1 bots=7
//     camera 46 49
//       at 46 player+110,-90,80 look=player      so far from the player
//       at 49 player+60,-120,60 look=player
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::player {

// A place that a camera passes at a time of the level, and the point that it looks at then; without one, it
// looks at the player.
struct CameraKey {
  double time_s = 0;
  // In the level, or relative to the player.
  math::Vec3 place{0.0f};
  bool is_relative = false;
  std::optional<math::Vec3> target_world;
};

struct TitlePlace {
  math::Vec3 place_world{0.0f};
  float yaw_deg = 0;
};

struct Shot {
  // On the level's clock.
  double begin_s = 0, end_s = 0;
  // Empty: the player's own view. Otherwise at least two, in order of time.
  std::vector<CameraKey> camera;
  std::optional<TitlePlace> title;

  bool is_flight() const { return !camera.empty(); }
};

// One game in one level.
struct FilmScene {
  std::string map;
  int skill = 1;
  std::uint64_t seed = 1;
  // More than 0: a deathmatch.
  std::uint32_t bots = 0;
  bool has_god = false, visits_stops = false;
  // At least one, in order of time. Flights come last, because no message takes the view back from a camera.
  std::vector<Shot> shots;
};

struct FilmScript {
  // Music of all scenes.
  std::uint8_t track = 0;
  // Model of the title; may be empty.
  std::string title_model;
  std::vector<FilmScene> scenes;
};

// Errors name the line.
base::Result<FilmScript> read_film_script(std::string_view text);

}  // namespace temblor::player
