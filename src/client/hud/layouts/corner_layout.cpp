#include "client/hud/layouts/corner_layout.h"

#include <span>

#include "client/hud/items.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

constexpr int kRowGap = 2, kIconHeight = 16, kFragsHeight = 8;

// Panels whose bottom is `bottom` pixels above the frame's bottom.
Panel at_left(const Panel& panel, int bottom, int height) {
  return panel.at(kCornerMargin * panel.scale(), panel.frame_height_px() - (bottom + height) * panel.scale());
}
Panel at_right(const Panel& panel, int width, int bottom, int height) {
  return panel.at(panel.frame_width_px() - (kCornerMargin + width) * panel.scale(),
                  panel.frame_height_px() - (bottom + height) * panel.scale());
}

// Draws the pictures in a row that ends at the right edge.
void draw_item_row(const Panel& panel, const Game& game, std::uint32_t items, const BarLook& look,
                   int bottom) {
  constexpr int kMarkX = 4, kMarkY = 4;
  int width = 0;
  const ItemLayout& layout = find_item_layout(look.pack);
  for (const std::span<const ItemIcon> icons : {layout.inventory, layout.bar})
    for (auto icon = icons.rbegin(); icon != icons.rend(); ++icon) {
      if ((icon->item & items & game.data.items) == 0) continue;
      width += panel.picture_size(icon->picture).width;
      const Panel place = at_right(panel, width, bottom, kIconHeight);
      place.draw_picture(icon->picture, 0, 0);
      if (look.safe_colors && icon->mark != 0)
        place.draw_character(static_cast<std::uint8_t>(icon->mark), kMarkX, kMarkY);
    }
}

}  // namespace

CornerHeights measure_corners(const Game& game, const CornerItems& items) {
  const int figure = kCornerMargin + kFigureHeight;
  int right = figure;
  if (items.are_shown) right += kRowGap + kIconHeight;
  if (items.are_shown && game.deathmatch) right += kRowGap + kFragsHeight;
  return {figure + kRowGap + kFigureHeight, right};
}

void draw_corners(const Panel& panel, const Game& game, const HudTimes& times, double time_s,
                  const BarLook& look, const CornerItems& items) {
  int bottom = kCornerMargin;
  const Panel health = at_left(panel, bottom, kFigureHeight);
  draw_face(health, 0, game, time_s < times.pain_until_s);
  draw_health_number(health, kFigureIconWidth, game, look);
  if (uses_ammo(game, look.pack))
    draw_ammo(at_right(panel, kFigureWidth, bottom, kFigureHeight), 0, game, look);
  bottom += kFigureHeight + kRowGap;
  // Without a bar around it, a 0 would have nothing that says it is armor.
  if (game.stat(Stat::kArmor) > 0 || has_items(game, kItemInvulnerability))
    draw_armor(at_left(panel, bottom, kFigureHeight), 0, game, look, time_s - times.armor_dropped_s);
  if (!items.are_shown) return;
  draw_item_row(panel, game, items.items, look, bottom);
  bottom += kIconHeight + kRowGap;
  if (game.deathmatch) draw_leaders(at_right(panel, kScreenWidth, bottom, kFragsHeight), game);
}

void draw_minimal(const Panel& panel, const Game& game, const BarLook& look) {
  draw_health_number(at_left(panel, kCornerMargin, kFigureHeight), 0, game, look);
  if (uses_ammo(game, look.pack))
    draw_ammo_number(at_right(panel, kFigureWidth - kFigureIconWidth, kCornerMargin, kFigureHeight), 0, game,
                     look);
}

}  // namespace temblor::client
