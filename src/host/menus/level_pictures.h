// Two pictures of a level for the menus: a room, and the whole level from above.
//
//   load level -> render more samples than pixels -> expose (brighten) -> average -> nearest palette colors
//
// The room is seen from the level's first intermission camera, or else from its start. Takes longer than a
// frame, so call it on another thread.
#pragma once

#include <optional>
#include <string>

#include "formats/images/nearest_color.h"
#include "formats/images/picture.h"
#include "host/session/game_data.h"

namespace temblor::host {

struct LevelPictures {
  formats::Picture room;      // 320 x 200
  formats::Picture overview;  // 160 x 100
};

// Returns nothing if the level cannot be loaded. `colors`: of the palette in data.look.
std::optional<LevelPictures> draw_level_pictures(const GameData& data, const std::string& name,
                                                 const formats::NearestColor& colors);

}  // namespace temblor::host
