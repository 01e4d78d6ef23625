// Makes the demo of a film: plays each scene of its script with the scripted player, records it from the
// player's eyes or the camera, and cuts the shots out of the recording.
#pragma once

#include <filesystem>

#include "base/bytes.h"
#include "base/result.h"
#include "scripted_player/film/film_script.h"

namespace temblor::player {

struct Film {
  base::ByteVector demo;
  double length_s = 0;
};

// Errors name the level of the scene, or the file that cannot be used.
base::Result<Film> make_film(const FilmScript& script, const std::filesystem::path& base_folder);

}  // namespace temblor::player
