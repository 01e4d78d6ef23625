// The heads-up display: status bar or other layouts, notices, center text, crosshair, intermission and finale
// screens, as a render::DrawList.
//
// ClientState: Game, Events --advance()--> times of pickups, pain, death --draw()--> render::DrawList
//
// Everything is laid out on the original's 320 x 200 screen and scaled by a whole number (hud/panel.h); text
// that can be broken into lines may be larger. Most of what is drawn is in the Game already; this class adds
// only when things happened.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "assets/mission_pack.h"
#include "assets/pictures.h"
#include "client/hud/crosshair.h"
#include "client/hud/hud_parts.h"
#include "client/hud/notices/notices.h"
#include "client/session/client_state.h"
#include "render/draw_list.h"
#include "render/scene.h"

namespace temblor::client {

// How much of the status bar is shown. kSmall: without the inventory row, or in the corners without items.
enum class StatusBar { kNone, kSmall, kFull };

// The values of the variable `scr_hudstyle`. kClassic is the original's status bar.
enum class HudLayout { kClassic, kCorners, kMinimal };

struct HudSettings {
  HudLayout layout = HudLayout::kClassic;
  StatusBar status_bar = StatusBar::kFull;
  HudSize size{};
  // Opacity of the status bar's background, 0 to 1.
  float opacity = 1;
  CrosshairLook crosshair{};
  NoticeSettings notices{};
  // The player's view, for the directions of damage.
  std::optional<render::Camera> camera{};
  // How long a message stays in the middle of the screen, and how fast the text of a finale appears.
  double center_text_s = 2, letters_per_second = 8;
  // +showscores is held.
  bool shows_scores = false;
  // The hints for a dead player, in lines; the text must stay alive while drawing.
  std::string_view death_hint{};
  // The level's par time, for the intermission; 0: none.
  float par_s = 0;
  // The rule of that name, for the scores of teams and Dissolution of Eternity's games with flags. Servers do
  // not send it, so this is the player's own variable, as in other engines.
  int teamplay = 0;
  // Adds marks to information that the original shows only by color.
  bool safe_colors = false;
  // The parts to draw; a HUD program draws the others.
  HudParts parts{};
};

// When the things happened that the bar shows, in server time; far in the past for never.
struct HudTimes {
  // The face shows pain until then.
  double pain_until_s = 0;
  double died_s = 0;
  // When armor was lost.
  double armor_dropped_s = 0;
  // Indexed by bit of net::ClientData::items.
  std::array<double, 32> item_gained_s{};
};

class Hud {
 public:
  explicit Hud(const assets::Pictures& pictures, assets::MissionPack pack = assets::MissionPack::kNone)
      : pictures_(pictures), pack_(pack), notices_(pack) {
    begin_level();
  }

  // Forgets everything; items in the first packet count as just gained.
  void begin_level();
  // Records pickups, pain and death for the bar. If time runs backward (a demo was rewound), starts over.
  void advance(const Game& game, const Events& events, double time_s);
  // Draws the display of server time `time_s`. Appends to `io_list` for a frame of `width` x `height` pixels;
  // the commands are valid while the pictures live.
  void draw(const Game& game, double time_s, int width, int height, const HudSettings& settings,
            render::DrawList& io_list) const;
  // How far the weapon list reaches up from the frame's bottom, in frame pixels; 0: it is not shown.
  int weapon_list_height_px(const Game& game, double time_s, int width, int height,
                            const HudSettings& settings) const;

 private:
  const assets::Pictures& pictures_;
  assets::MissionPack pack_;
  HudTimes times_;
  Notices notices_;
  // The state at the last advance().
  std::uint32_t items_ = 0;
  int armor_ = 0;
  double last_time_s_ = 0;
  bool is_dead_ = false;
};

}  // namespace temblor::client
