// The textures of a level for its report: pictures, sizes, and how much of the level they cover.
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "formats/images/palette.h"
#include "world/level.h"

namespace temblor::app {

// Returns a <section>. `missing`: names that no WAD had, in any case. Fails if a picture cannot be written.
base::Result<std::string> write_texture_table(const world::Level& level, std::span<const std::string> missing,
                                              const formats::Palette& palette);

}  // namespace temblor::app
