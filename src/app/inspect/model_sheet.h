// Pictures of a model from several sides and in several frames, on one sheet: for those who make models.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace temblor::app {

struct SheetOptions {
  std::string out;                        // a .png
  std::string frames;                     // "0,12,walk1": numbers and names; empty: eight, evenly spread
  std::string views = "front,side,back";  // front, side, back, above, quarter, hand (a weapon's own)
  int cell_px = 240;                      // sides of a picture
  int skin = 0;
  int light = 120;  // 0 to 255: of the floor
};

// Draws frames side by side, a row for each view, with the renderer, in a room whose floor is where the first
// frame's lowest point is. The palette is gfx/palette.lmp of the game folder that the model lies in
// (progs/NAME.mdl), else the shipped game's. Errors: no model, a frame or view that there is not.
base::Status draw_model_sheet(const std::filesystem::path& model_file, const SheetOptions& options);

}  // namespace temblor::app
