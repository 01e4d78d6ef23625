#include "client/hud/hud.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "client/hud/center_text.h"
#include "client/hud/ending.h"
#include "client/hud/panel.h"
#include "client/hud/scoreboard.h"
#include "client/hud/status_bar.h"

namespace temblor::client {

namespace {

// How long the face shows pain, as in the original, and how long after a death its hint appears.
constexpr double kPainSeconds = 0.2, kHintAfterSeconds = 1;

// The score bar replaces the status bar while the player is dead or looks at the scores.
void draw_bars(const Panel& panel, const Game& game, const HudTimes& times, double time_s,
               const HudSettings& settings, assets::MissionPack pack) {
  const BarLook look{settings.opacity, settings.safe_colors, pack, settings.teamplay};
  const Panel bar = panel.at_bottom(kBarHeight);
  if (!settings.parts.bars) {
    if (settings.parts.scores && settings.shows_scores)
      draw_level_scores(bar, game, time_s, settings.opacity);
    return;
  }
  if (settings.status_bar == StatusBar::kNone) {
    if (settings.shows_scores) draw_level_scores(bar, game, time_s, settings.opacity);
    return;
  }
  if (settings.status_bar == StatusBar::kFull)
    draw_inventory(panel.at_bottom(kBarHeight + kInventoryHeight), game, times, time_s, look);
  if (game.stat(Stat::kHealth) <= 0 || settings.shows_scores)
    draw_level_scores(bar, game, time_s, settings.opacity);
  else
    draw_status_bar(bar, game, times, time_s, look);
}

// Draws the hint above the status bar, whose height stays free even if it is hidden.
void draw_death_hint(const Panel& panel, const Panel& letters, std::string_view hint) {
  constexpr int kGap = 6;
  const int bottom = panel.frame_height_px() - (kBarHeight + kInventoryHeight + kGap) * panel.scale();
  const int height = count_text_lines(letters, hint) * kTextLine * letters.scale();
  draw_text_lines(letters.with_top(bottom - height), hint, kTextLine);
}

// Draws everything of a running level. The ranking hides center texts, as both are in the middle. The
// crosshair is no text, so it does not grow with it.
void draw_play(const Panel& panel, const Panel& letters, const Game& game, const HudTimes& times,
               double time_s, const HudSettings& settings, assets::MissionPack pack) {
  const HudParts& parts = settings.parts;
  const int crosshair_scale =
      choose_scale(panel.frame_width_px(), panel.frame_height_px(), {settings.size.scale});
  if (parts.crosshair && game.stat(Stat::kHealth) > 0)
    draw_crosshair(panel.with_scale(crosshair_scale), settings.crosshair);
  draw_bars(panel, game, times, time_s, settings, pack);
  const bool is_dead_in_deathmatch = game.deathmatch && game.stat(Stat::kHealth) <= 0;
  if (parts.scores && (is_dead_in_deathmatch || (settings.shows_scores && game.players.size() > 1)))
    draw_ranking(panel.in_middle(kScreenHeight), game);
  else if (parts.center_text && time_s - game.center_text_since_s < settings.center_text_s)
    draw_center_text(letters, game.center_text);
  if (parts.hints && game.stat(Stat::kHealth) <= 0 && time_s - times.died_s >= kHintAfterSeconds)
    draw_death_hint(panel, letters, settings.death_hint);
}

void draw_pause(const Panel& panel) {
  constexpr int kY = 64;  // the middle of the area above the status bar
  panel.in_middle(kScreenHeight).draw_centered_picture("gfx/pause.lmp", kY);
}

}  // namespace

void Hud::begin_level() {
  constexpr double kNever = std::numeric_limits<double>::lowest();
  times_.pain_until_s = kNever;
  times_.item_gained_s.fill(kNever);
  times_.died_s = kNever;
  times_.armor_dropped_s = kNever;
  armor_ = 0;
  is_dead_ = false;
  items_ = 0;
  last_time_s_ = kNever;
}

void Hud::advance(const Game& game, const Events& events, double time_s) {
  if (events.new_level || time_s < last_time_s_) begin_level();
  last_time_s_ = time_s;
  const std::uint32_t gained = game.data.items & ~items_;
  items_ = game.data.items;
  for (std::size_t bit = 0; bit < times_.item_gained_s.size(); ++bit)
    if ((gained >> bit & 1) != 0) times_.item_gained_s[bit] = time_s;
  if (const int armor = game.stat(Stat::kArmor); armor < std::exchange(armor_, armor))
    times_.armor_dropped_s = time_s;
  // Only the change to dead sets the time of death.
  const bool is_dead = game.stat(Stat::kHealth) <= 0;
  if (is_dead && !std::exchange(is_dead_, is_dead)) times_.died_s = time_s;
  is_dead_ = is_dead;
  for (const net::Damage& damage : events.damages)
    if (damage.armor > 0 || damage.blood > 0) times_.pain_until_s = time_s + kPainSeconds;
}

void Hud::draw(const Game& game, double time_s, int width, int height, const HudSettings& settings,
               render::DrawList& io_list) const {
  const Panel panel(pictures_, io_list, width, height, choose_scale(width, height, settings.size));
  const Panel letters = panel.with_scale(choose_text_scale(width, height, settings.size));
  switch (game.ending) {
    case Ending::kNone:
      draw_play(panel, letters, game, times_, time_s, settings, pack_);
      break;
    case Ending::kIntermission:
      if (settings.parts.ending) draw_intermission(panel, game, settings.par_s);
      break;
    case Ending::kFinale:
    case Ending::kCutScene:
      draw_finale(panel, letters, game, time_s, settings.letters_per_second);
      break;
  }
  if (game.paused) draw_pause(panel);
}

}  // namespace temblor::client
