// Pictures that replace the textures of a level, as in most Quake engines:
//
//   textures/MAP/NAME      for the level MAP only
//   textures/NAME          for all levels
//   ..._glow or ..._luma   next to it: the light that the texture emits
//
// NAME is the texture's name in lower case, with '#' for '*'; image_files.h lists the extensions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/levels/bsp.h"
#include "vfs/file_system.h"
#include "world/level.h"

namespace temblor::assets {

// The pictures of all levels of detail of a level take at most this much memory.
constexpr std::size_t kMaxExternalTextureBytes = std::size_t{1} << 30;
// Pixels of one picture.
constexpr std::size_t kMaxExternalTexturePixels = std::size_t{1} << 24;

// Loads the pictures of `bsp`, which was read from maps/MAP.bsp, on all cores. A picture that is damaged or
// too large is ignored, with a note. Returns nothing if there are no pictures, or if the game has no palette.
world::ColoredTextures load_external_textures(const vfs::FileSystem& files, std::string_view map_name,
                                              const formats::Bsp& bsp, std::vector<std::string>& io_notes);

}  // namespace temblor::assets
