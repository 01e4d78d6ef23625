// The 2D pictures of the game (status bar, menus, console background, font): the lumps of gfx.wad and
// gfx/*.lmp, loaded once, with pictures in color that are shown in their place (images/external_pictures.h).
// Always complete: a stock picture that is missing gets a checkerboard, so that no drawing code needs a
// check.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "formats/images/picture.h"
#include "vfs/file_system.h"

namespace temblor::assets {

class Pictures {
 public:
  // Loads everything in gfx.wad and gfx/. Stock pictures that are missing or damaged become checkerboard
  // placeholders of the right size, with one line in `io_notes` for all of them.
  static Pictures load(const vfs::FileSystem& files, std::vector<std::string>& io_notes);

  // Finds a picture by case-insensitive name: "sbar", "num_0" (gfx.wad), "gfx/complete.lmp". Returns null
  // only for a name that is neither loaded nor stock. The pointer is valid as long as this object, even if it
  // is moved.
  const formats::Picture* find(std::string_view name) const;
  // Like find(), but returns null for placeholders too, for code that can draw something better instead.
  const formats::Picture* find_real(std::string_view name) const;
  // The console font: 16 rows of 16 characters of 8 x 8 pixels.
  const formats::Picture& characters() const { return characters_; }

 private:
  formats::Picture* find_own(std::string_view name);

  std::map<std::string, formats::Picture, std::less<>> pictures_;  // by name in lower case
  std::set<std::string, std::less<>> placeholders_;                // names, as in pictures_
  formats::Picture characters_;
};

}  // namespace temblor::assets
