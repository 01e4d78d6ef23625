// The 2-D part of a frame: status bar, centre print, intermission and finale screens, as a DrawList.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/result.h"
#include "client/client_state.h"
#include "formats/picture.h"
#include "render/draw_list.h"
#include "vfs/file_system.h"

namespace temblor::client {

// Pictures of gfx.wad and gfx/, loaded once. One that is missing is a checker, and is noted once.
class HudPictures {
 public:
  static HudPictures load(const vfs::FileSystem& files, const formats::Palette& palette,
                          std::vector<std::string>& io_notes);
  // Null only for a name that load() does not know.
  const formats::Picture* find(std::string_view name) const;
  const formats::Picture& characters() const { return characters_; }

 private:
  std::unordered_map<std::string, formats::Picture> pictures_;
  formats::Picture characters_;
};

enum class StatusBar { kNone, kSmall, kFull };

struct HudSettings {
  StatusBar status_bar = StatusBar::kFull;
  int scale = 0;  // frame pixels for each of the original's; 0: as large as the frame's size asks for
  float opacity = 1;
};

class Hud {
 public:
  explicit Hud(const HudPictures& pictures) : pictures_(pictures) {}
  // Appends to `io_list`, for a frame of that size. Valid while the pictures live.
  void draw(const Game& game, double time_s, int width, int height, const HudSettings& settings,
            render::DrawList& io_list);

 private:
  const HudPictures& pictures_;
};

}  // namespace temblor::client
