#include "client/hud/layouts/layout.h"

#include <algorithm>

#include "client/hud/item_layout.h"
#include "client/hud/layouts/corner_layout.h"
#include "client/hud/layouts/status_bar.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

bool needs_score_bar(const LayoutFrame& frame) {
  const bool is_dead = frame.game.stat(Stat::kHealth) <= 0;
  return frame.settings.shows_scores || (frame.settings.status_bar != StatusBar::kNone && is_dead);
}

bool has_inventory(const HudSettings& settings) {
  return settings.layout == HudLayout::kClassic && settings.status_bar == StatusBar::kFull;
}

// Power-ups with timers are not shown twice.
CornerItems choose_corner_items(const LayoutFrame& frame) {
  const HudSettings& settings = frame.settings;
  return {settings.status_bar == StatusBar::kFull,
          settings.notices.power_timers ? ~find_item_layout(frame.pack).timed : ~0u};
}

// The height of the bars, which reach from side to side; 0: there are none.
int measure_bars(const LayoutFrame& frame) {
  const HudSettings& settings = frame.settings;
  const bool has_bar = settings.layout == HudLayout::kClassic && settings.status_bar != StatusBar::kNone;
  return (has_bar || needs_score_bar(frame) ? kBarHeight : 0) +
         (has_inventory(settings) ? kInventoryHeight : 0);
}

}  // namespace

LayoutHeights measure_layout(const LayoutFrame& frame) {
  const int bars = measure_bars(frame);
  if (bars > 0 || frame.settings.status_bar == StatusBar::kNone) return {bars, bars, bars};
  const CornerHeights corners = frame.settings.layout == HudLayout::kCorners
                                    ? measure_corners(frame.game, choose_corner_items(frame))
                                    : CornerHeights{kMinimalHeight, kMinimalHeight};
  // In a wide frame the sides, with a row of items, leave room for ten weapons between them.
  constexpr int kSideWidth = 162, kWeaponsWidth = 276;
  const Panel& panel = frame.panel;
  const bool has_room = panel.frame_width_px() / panel.scale() >= 2 * kSideWidth + kWeaponsWidth;
  return {corners.left, has_room ? 0 : std::max(corners.left, corners.right), corners.right};
}

void draw_layout(const LayoutFrame& frame) {
  const auto& [panel, game, times, time_s, settings, pack] = frame;
  const BarLook look{settings.opacity, settings.safe_colors, pack, settings.teamplay};
  const Panel bar = panel.at_bottom(kBarHeight);
  if (!settings.parts.bars) {
    if (settings.parts.scores && settings.shows_scores)
      draw_level_scores(bar, game, time_s, settings.opacity);
    return;
  }
  if (has_inventory(settings))
    draw_inventory(panel.at_bottom(kBarHeight + kInventoryHeight), game, times, time_s, look);
  if (needs_score_bar(frame))
    draw_level_scores(bar, game, time_s, settings.opacity);
  else if (settings.status_bar == StatusBar::kNone)
    return;
  else if (settings.layout == HudLayout::kCorners)
    draw_corners(panel, game, times, time_s, look, choose_corner_items(frame));
  else if (settings.layout == HudLayout::kMinimal)
    draw_minimal(panel, game, look);
  else
    draw_status_bar(bar, game, times, time_s, look);
}

}  // namespace temblor::client
