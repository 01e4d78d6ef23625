#include "client/hud/hud.h"

#include <limits>
#include <utility>

#include "client/hud/center_text.h"
#include "client/hud/ending.h"
#include "client/hud/layouts/layout.h"
#include "client/hud/panel.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

// How long the face shows pain, as in the original, and how long after a death its hint appears.
constexpr double kPainSeconds = 0.2, kHintAfterSeconds = 1;

// Draws the hint above the status bar, whose height stays free even if it is hidden.
void draw_death_hint(const Panel& panel, const Panel& letters, std::string_view hint) {
  constexpr int kGap = 6;
  const int bottom = panel.frame_height_px() - (kBarHeight + kInventoryHeight + kGap) * panel.scale();
  const int height = count_text_lines(letters, hint) * kTextLine * letters.scale();
  draw_text_lines(letters.with_top(bottom - height), hint, kTextLine);
}

// Whether players with the same pants are a team. Those with flags have scores if the server sends their
// captures.
bool has_team_scores(const Game& game, const HudSettings& settings) {
  return game.deathmatch && (settings.teamplay == 1 || settings.teamplay == 2 || has_captures(game));
}

// Draws everything of a running level. The ranking hides center texts, as both are in the middle. The
// crosshair is no text, so it does not grow with it.
void draw_play(const LayoutFrame& frame, const Panel& letters, const Notices& notices) {
  const auto& [panel, game, times, time_s, settings, pack] = frame;
  const HudParts& parts = settings.parts;
  const bool is_alive = game.stat(Stat::kHealth) > 0;
  const int crosshair_scale =
      choose_scale(panel.frame_width_px(), panel.frame_height_px(), {settings.size.scale});
  if (parts.crosshair && is_alive) draw_crosshair(panel.with_scale(crosshair_scale), settings.crosshair);
  if (parts.bars && is_alive)
    notices.draw(panel, game, time_s, settings.notices, measure_layout(frame), settings.camera);
  draw_layout(frame);
  if (parts.scores &&
      ((game.deathmatch && !is_alive) || (settings.shows_scores && game.players.size() > 1))) {
    if (has_team_scores(game, settings)) draw_team_scores(panel.in_middle(kScreenHeight), game);
    draw_ranking(panel.in_middle(kScreenHeight), game);
  } else if (parts.center_text && time_s - game.center_text_since_s < settings.center_text_s)
    draw_center_text(letters, game.center_text);
  if (parts.hints && !is_alive && time_s - times.died_s >= kHintAfterSeconds)
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
  notices_.begin_level();
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
  notices_.advance(game, events, time_s);
}

void Hud::draw(const Game& game, double time_s, int width, int height, const HudSettings& settings,
               render::DrawList& io_list) const {
  const Panel panel(pictures_, io_list, width, height, choose_scale(width, height, settings.size));
  const Panel letters = panel.with_scale(choose_text_scale(width, height, settings.size));
  switch (game.ending) {
    case Ending::kNone:
      draw_play({panel, game, times_, time_s, settings, pack_}, letters, notices_);
      break;
    case Ending::kIntermission:
      if (!settings.parts.ending) break;
      if (has_team_scores(game, settings)) draw_team_scores(panel.in_middle(kScreenHeight), game);
      draw_intermission(panel, game, settings.par_s);
      break;
    case Ending::kFinale:
    case Ending::kCutScene:
      draw_finale(panel, letters, game, time_s, settings.letters_per_second);
      break;
  }
  if (game.paused) draw_pause(panel);
}

int Hud::weapon_list_height_px(const Game& game, double time_s, int width, int height,
                               const HudSettings& settings) const {
  if (!settings.notices.weapons || !settings.parts.bars || !notices_.shows_weapons(time_s) ||
      game.ending != Ending::kNone || game.stat(Stat::kHealth) <= 0)
    return 0;
  render::DrawList unused;
  const int scale = choose_scale(width, height, settings.size);
  const LayoutHeights heights =
      measure_layout({Panel(pictures_, unused, width, height, scale), game, times_, time_s, settings, pack_});
  return (heights.middle + kNoticeGap + kWeaponListHeight) * scale;
}

}  // namespace temblor::client
