// The game's 2-D pictures: gfx.wad's lumps and gfx/*.lmp, loaded once.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formats/picture.h"
#include "vfs/file_system.h"

namespace temblor::assets {

class Pictures {
 public:
  // What is missing or damaged is a checker in its place, with one line in `io_notes` for all of it.
  static Pictures load(const vfs::FileSystem& files, std::vector<std::string>& io_notes);

  // "sbar", "num_0" (gfx.wad), "gfx/complete.lmp". Null only for a name that no stock game has.
  const formats::Picture* find(std::string_view name) const;
  // 16 rows of 16 characters of 8 x 8 pixels.
  const formats::Picture& characters() const { return characters_; }

 private:
  std::unordered_map<std::string, formats::Picture> pictures_;
  formats::Picture characters_;
};

}  // namespace temblor::assets
