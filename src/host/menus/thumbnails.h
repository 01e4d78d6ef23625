// Small pictures of levels and saved games for the menus, in the palette's colors.
//
// The picture of a saved game is a PNG file next to it, NAME.png for NAME.sav. A level has no picture of its
// own, so it is drawn from above with an orthographic camera. This takes place on another thread, one level
// at a time, because loading a level takes longer than a frame:
//
//   load level -> render at 4 x 4 samples per pixel -> expose (brighten) -> average -> nearest palette colors
#pragma once

#include <cstdint>
#include <future>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "assets/library.h"
#include "base/result.h"
#include "formats/images/nearest_color.h"
#include "formats/images/picture.h"
#include "host/session/game_data.h"

namespace temblor::host {

constexpr int kThumbnailWidth = 160, kThumbnailHeight = 100;

// Scales a picture to the thumbnail size with a box filter: each pixel is the mean of the pixels that it
// covers. `rgb` holds rows of `width` pixels 0xffRRGGBB, from top to bottom; the picture must not be empty.
formats::Picture make_thumbnail(std::span<const std::uint32_t> rgb, int width, int height,
                                const formats::NearestColor& colors);

class Thumbnails {
 public:
  // `data` must outlive this object.
  explicit Thumbnails(const GameData& data);
  // Waits for the level that is being drawn.
  ~Thumbnails();

  // The picture of a saved game. Null if there is none. Valid until the next call.
  const formats::Picture* save_picture(const std::string& name);
  // The picture of a level. Null while it is being drawn, and if the level cannot be loaded. Call it again in
  // later frames until the picture is there. Valid until the next call.
  const formats::Picture* level_picture(const std::string& name);
  // Call it after the picture of a saved game has been written, so that it is read again.
  void forget_save(const std::string& name) { saves_.erase(name); }
  std::filesystem::path save_picture_file(const std::string& name) const;
  const formats::NearestColor& colors() const { return colors_; }

 private:
  const GameData& data_;
  formats::NearestColor colors_;
  // Caches by name. No value: there is no picture, and reading or drawing it is not tried again.
  std::map<std::string, std::optional<formats::Picture>> saves_, levels_;
  std::string drawn_level_;  // the level of `drawing_`
  std::future<std::optional<formats::Picture>> drawing_;
};

}  // namespace temblor::host
