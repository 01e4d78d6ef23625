// Finds the light samples of a level's faces: where they are in the file, and where they lie on the face.
#pragma once

#include <cstdint>

#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

// BspTexinfo::flags: a surface without light maps.
constexpr std::int32_t kFlagNoLight = 1;

// Sets styles, light, and light_map_grid of io_level.faces, and io_level.light_map_grids. All else in the
// level must be complete. Uses DECOUPLED_LM, else LMSHIFT, else the faces of the file. A lump that does not
// fit the level is left out, with a note. A face whose own light is outside of the samples has none, with a
// note; neither has a large face if others share the samples too often. A style above 63 is style 0.
void set_light_maps(const formats::Bsp& bsp, Level& io_level);

}  // namespace temblor::world
