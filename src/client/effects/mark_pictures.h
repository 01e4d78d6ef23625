// The pictures of the game directory that marks can show, gfx/marks/NAME.png. All are loaded at once, so that
// a server can ask only for files that are there, and so that a picture never has to be read during the game.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "assets/library.h"
#include "render/mark_picture.h"

namespace temblor::client {

class MarkPictures {
 public:
  // A picture of 256 x 256 pixels takes 0.4 MB.
  static constexpr std::size_t kMaxPictures = 128;

  // Empty.
  MarkPictures() = default;
  // Loads the first kMaxPictures files by name. Files that cannot be used are left out, with a line in
  // `io_notes` for each.
  static MarkPictures load(const assets::Library& library, std::vector<std::string>& io_notes);

  // `name` is in lower case, such as "smile" for gfx/marks/smile.png. Null if there is none.
  std::shared_ptr<const render::MarkPicture> find(std::string_view name) const;

 private:
  std::map<std::string, std::shared_ptr<const render::MarkPicture>, std::less<>> pictures_;
};

}  // namespace temblor::client
