// The pictures that a HUD program names: those of gfx.wad and gfx/*.lmp, and PNG, TGA, and JPEG files of the
// game folders. `rgb` frames show the files' own colors and opacities, `indexed` frames the nearest entries
// of the palette.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "assets/library.h"
#include "assets/pictures.h"
#include "formats/images/nearest_color.h"

namespace temblor::client {

class ProgramPictures {
 public:
  // More files, or larger ones, are not loaded: they count as missing.
  static constexpr std::size_t kMaxFiles = 1024;
  static constexpr std::uint32_t kMaxSide = 2048;
  // The pixels of all files; each takes six bytes.
  static constexpr std::size_t kMaxPixels = std::size_t{1} << 26;

  // All of them must outlive this object.
  ProgramPictures(const assets::Library& library, const assets::Pictures& pictures,
                  const formats::Palette& palette);

  // Finds "gfx/sell.lmp", "gfx/sell", "sb_shotgun" (gfx.wad), or "gfx/hud/face.png", ignoring case. Loads a
  // file when it is first named. Null if there is no such picture, or if it is damaged. Pointers stay valid.
  const formats::Picture* find(std::string_view name);

 private:
  const formats::Picture* find_lump(std::string_view name) const;
  const formats::Picture* load_file(const std::string& name);

  const assets::Library& library_;
  const assets::Pictures& pictures_;
  formats::NearestColor nearest_;
  std::map<std::string, const formats::Picture*, std::less<>> found_;  // null: there is none
  std::map<std::string, formats::Picture, std::less<>> files_;
  std::size_t file_pixels_ = 0;
};

}  // namespace temblor::client
