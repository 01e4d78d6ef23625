// Pictures in color that are shown in place of the game's own 2D pictures (status bar, menus, console), as in
// today's engines:
//
//   gfx/NAME   instead of the lump NAME of gfx.wad, or of gfx/NAME.lmp
//
// image_files.h lists the extensions. A picture in a lower game folder than the one that it would replace is
// ignored. It is drawn at that one's size.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/images/picture.h"
#include "vfs/file_system.h"

namespace temblor::assets {

constexpr std::size_t kMaxExternalPicturePixels = std::size_t{1} << 23;

// Gives details to pictures. `find` returns the picture of a lump, "sbar", or of a file, "gfx/complete.lmp",
// or null; the names of those that got a detail are returned. Damaged and larger files are ignored, and added
// to `io_bad`.
std::vector<std::string> add_details(const vfs::FileSystem& files,
                                     const std::function<formats::Picture*(std::string_view name)>& find,
                                     std::vector<std::string>& io_bad);

}  // namespace temblor::assets
