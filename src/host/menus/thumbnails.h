// Small pictures for the menus, in the palette's colors.
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
#include "host/game_data.h"

namespace temblor::host {

constexpr int kThumbnailWidth = 160, kThumbnailHeight = 100;

// Each pixel the mean of what it stands for. `rgb`: rows of `width` pixels 0xffRRGGBB.
formats::Picture make_thumbnail(std::span<const std::uint32_t> rgb, int width, int height,
                                const formats::NearestColor& colors);

// Those of saved games, beside them, and of levels, drawn from above on another thread when they are first
// asked for.
class Thumbnails {
 public:
  // `data` must outlive it.
  explicit Thumbnails(const GameData& data);
  ~Thumbnails();

  // Null: there is none. Valid until the next call.
  const formats::Picture* of_save(const std::string& name);
  // Null: not yet, or none. Valid until the next call.
  const formats::Picture* of_level(const std::string& name);
  // A new one lies beside the saved game.
  void forget_save(const std::string& name) { saves_.erase(name); }
  std::filesystem::path file_of_save(const std::string& name) const;
  const formats::NearestColor& colors() const { return colors_; }

 private:
  const GameData& data_;
  formats::NearestColor colors_;
  std::map<std::string, std::optional<formats::Picture>> saves_, levels_;
  std::string drawn_level_;  // by `drawing_`
  std::future<std::optional<formats::Picture>> drawing_;
};

}  // namespace temblor::host
