// The game's 2-D pictures: gfx.wad's lumps and gfx/*.lmp, loaded once.
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
  // All of gfx.wad and all of gfx/. What a stock game has and is missing here, or damaged, is a checker of
  // its size in its place, with one line in `io_notes` for all of it.
  static Pictures load(const vfs::FileSystem& files, std::vector<std::string>& io_notes);

  // "sbar", "num_0" (gfx.wad), "gfx/complete.lmp"; case does not matter. Null only for a name that neither
  // these files nor a stock game have. Valid while this lives, also when it is moved.
  const formats::Picture* find(std::string_view name) const;
  // The same, but null too where the picture would be a stand-in.
  const formats::Picture* find_real(std::string_view name) const;
  // 16 rows of 16 characters of 8 x 8 pixels.
  const formats::Picture& characters() const { return characters_; }

 private:
  std::map<std::string, formats::Picture, std::less<>> pictures_;  // by name in lower case
  std::set<std::string, std::less<>> placeholders_;                // names, as in pictures_
  formats::Picture characters_;
};

}  // namespace temblor::assets
