// Small pictures of levels and saved games for the menus, in the palette's colors.
//
// The picture of a saved game is a PNG file next to it, NAME.png for NAME.sav. A level has no pictures of its
// own, so they are drawn (level_pictures.h), on another thread and one level at a time.
#pragma once

#include <future>
#include <map>
#include <optional>
#include <string>

#include "assets/library.h"
#include "base/result.h"
#include "formats/images/nearest_color.h"
#include "formats/images/picture.h"
#include "host/menus/level_pictures.h"
#include "host/menus/make_thumbnail.h"
#include "host/session/game_data.h"

namespace temblor::host {

class Thumbnails {
 public:
  // `data` must outlive this object.
  explicit Thumbnails(const GameData& data);
  // Waits for the level that is being drawn.
  ~Thumbnails();

  // The picture of a saved game. Null if there is none. Valid until the next call.
  const formats::Picture* save_picture(const std::string& name);
  // The pictures of a level. Null while they are being drawn, and if the level cannot be loaded. Call it
  // again in later frames until they are there. Valid until the next call.
  const LevelPictures* level_pictures(const std::string& name);
  // Call it after the picture of a saved game has been written, so that it is read again.
  void forget_save(const std::string& name) { saves_.erase(name); }
  std::filesystem::path save_picture_file(const std::string& name) const;
  const formats::NearestColor& colors() const { return colors_; }

 private:
  const GameData& data_;
  formats::NearestColor colors_;
  // Caches by name. No value: there is no picture, and reading or drawing it is not tried again.
  std::map<std::string, std::optional<formats::Picture>> saves_;
  std::map<std::string, std::optional<LevelPictures>> levels_;
  std::string drawn_level_;  // the level of `drawing_`
  std::future<std::optional<LevelPictures>> drawing_;
};

}  // namespace temblor::host
