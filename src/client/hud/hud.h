// The 2-D part of a frame: status bar, center print, intermission and finale screens, as a DrawList.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "assets/pictures.h"
#include "client/hud/crosshair.h"
#include "client/session/client_state.h"
#include "render/draw_list.h"

namespace temblor::client {

enum class StatusBar { kNone, kSmall, kFull };  // kSmall: without the inventory

struct HudSettings {
  StatusBar status_bar = StatusBar::kFull;
  int scale = 0;      // frame pixels for each of the original's; 0: as large as the frame's size asks for
  float opacity = 1;  // of what the status bar stands on, 0 to 1
  CrosshairLook crosshair{};
  bool shows_scores = false;      // asked for: what the level still holds, and in a game of several who leads
  std::string_view death_hint{};  // lines that tell the dead what they can do; must live while it is drawn
  bool safe_colors = false;       // what the original tells by color alone is told by a mark as well
};

// What it shows of the past. Far in the past: never.
struct HudTimes {
  double pain_until_s = 0;  // the face is in pain
  double died_s = 0;
  std::array<double, 32> item_gained_s{};  // by bit of net::ClientData::items
};

class Hud {
 public:
  explicit Hud(const assets::Pictures& pictures) : pictures_(pictures) { begin_level(); }

  void begin_level();
  // What flashes: new weapons, and the face of who was hurt; when he died. Time that runs backwards begins
  // the level anew.
  void advance(const Game& game, const Events& events, double time_s);
  // Appends to `io_list`, for a frame of that size. Valid while the pictures live.
  void draw(const Game& game, double time_s, int width, int height, const HudSettings& settings,
            render::DrawList& io_list) const;

 private:
  const assets::Pictures& pictures_;
  HudTimes times_;
  std::uint32_t items_ = 0;
  double last_time_s_ = 0;
  bool is_dead_ = false;
};

}  // namespace temblor::client
