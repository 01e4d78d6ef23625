// A sheet with pictures of a model in several frames and from several sides, for authors of models:
//
//              frame 0   frame 7   ...
//     front  |  cell   |  cell   |
//     side   |  cell   |  cell   |
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace temblor::app {

struct SheetOptions {
  // Name of the .png.
  std::string out;
  // Numbers and names, "0,12,walk1"; empty: up to eight, evenly spaced.
  std::string frames;
  // Any of front, side, back, above, quarter, and hand (as the view weapon).
  std::string views = "front,side,back";
  // Width and height of a cell in pixels.
  int cell_px = 240;
  int skin = 0;
  // Light level of the room, 0 to 255.
  int light = 120;
};

// Draws the sheet with the game's renderer, in a room whose floor is at the lowest point of the model's first
// frame. Draws .mdl, .md3, and .md5mesh files. The palette is gfx/palette.lmp of the game directory that
// contains progs/NAME.mdl, otherwise Temblor's own. Errors: a file that is not a model, an unknown frame or
// view, a sheet that is too large.
base::Status draw_model_sheet(const std::filesystem::path& model_file, const SheetOptions& options);

}  // namespace temblor::app
