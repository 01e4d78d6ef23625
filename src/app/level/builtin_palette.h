// Whether a level without game data may need another palette than Temblor's own.
#pragma once

#include "app/commands/options.h"
#include "base/result.h"
#include "world/level.h"

namespace temblor::app {

// Returns whether all textures of the level are Temblor's own (the built-in ones and those of the shipped
// game, if it is there), missing, or have palettes of their own. The palette is not stored in a level, so
// equal texels are the only sign that it is the right one.
base::Result<bool> fits_builtin_palette(const world::Level& level, const GameFolders& folders);

}  // namespace temblor::app
