#include "client/hud/notices/pickups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "client/hud/item_layout.h"
#include "client/hud/items.h"
#include "client/hud/layouts/player_figures.h"

namespace temblor::client {

namespace {

constexpr double kPickupLasts_s = 3, kPickupFades_s = 0.5;

}  // namespace

void PickupList::add(std::string picture, int amount, double time_s) {
  const auto same = std::ranges::find(lines_, picture, &Line::picture);
  if (same != lines_.end()) {
    amount += same->amount;
    lines_.erase(same);
  }
  if (lines_.size() == kMaxPickups) lines_.erase(lines_.begin());
  lines_.push_back({std::move(picture), amount, time_s});
}

void PickupList::add_items(std::uint32_t gained, assets::MissionPack pack, double time_s) {
  const ItemLayout& layout = find_item_layout(pack);
  for (const std::span<const WeaponSlot> weapons : {layout.weapons, layout.extra_weapons})
    for (const WeaponSlot& weapon : weapons)
      if ((gained & weapon.item) != 0) add(fmt::format("inv_{}", weapon.name), 0, time_s);
  if (pack == assets::MissionPack::kRogue)
    for (std::size_t slot = 0; slot < layout.weapons.size(); ++slot)
      if (const char* const picture = find_rogue_picture(gained & kRogueOtherWeapons, slot))
        add(picture, 0, time_s);
  for (const std::span<const ItemIcon> icons : {layout.inventory, layout.bar})
    for (const ItemIcon& icon : icons)
      if ((gained & icon.item) != 0) add(icon.picture, 0, time_s);
}

void PickupList::add_amounts(const Holdings& now, bool has_flashed, assets::MissionPack pack, double time_s) {
  // Some mods heal the player all the time, in small steps and without the flash of a pickup.
  constexpr int kMinHealing = 5;
  if (const int gain = now.health - before_.health; gain >= kMinHealing || (gain > 0 && has_flashed))
    add("face1", gain, time_s);
  if (const int kind = find_armor_kind(now.items, pack); now.armor > before_.armor && kind > 0)
    add(kArmorPictures[static_cast<std::size_t>(kind) - 1], now.armor - before_.armor, time_s);
  // Dissolution of Eternity sends the counts of the other ammo while its weapons are in hand.
  if (pack == assets::MissionPack::kRogue && now.weapon != before_.weapon) return;
  constexpr std::array kPictures = {"sb_shells", "sb_nails", "sb_rocket", "sb_cells"};
  for (std::size_t kind = 0; kind < kPictures.size(); ++kind)
    if (const int gain = now.ammo[kind] - before_.ammo[kind]; gain > 0) add(kPictures[kind], gain, time_s);
}

void PickupList::advance(const Game& game, const Events& events, assets::MissionPack pack, double time_s,
                         bool is_watched) {
  std::erase_if(lines_, [&](const Line& line) { return time_s - line.since_s >= kPickupLasts_s; });
  const Holdings now{game.data.items,
                     find_weapon_in_hand(game, pack),
                     game.stat(Stat::kHealth),
                     game.stat(Stat::kArmor),
                     {game.stat(Stat::kShells), game.stat(Stat::kNails), game.stat(Stat::kRockets),
                      game.stat(Stat::kCells)}};
  if (is_watched) {
    add_amounts(now, events.bonus_flashes > 0, pack, time_s);
    add_items(now.items & ~before_.items, pack, time_s);
  }
  before_ = now;
}

void PickupList::draw(const Panel& panel, int max_lines, double time_s) const {
  constexpr int kIconWidth = 24, kTextY = 8;
  constexpr float kBackground = 0.4f;
  int y = 0;
  for (auto line = lines_.rbegin(); line != lines_.rend() && max_lines > 0; ++line, --max_lines) {
    y -= kPickupHeight;
    const double left_s = line->since_s + kPickupLasts_s - time_s;
    const auto opacity = static_cast<float>(std::clamp(left_s / kPickupFades_s, 0.0, 1.0));
    const std::string text = line->amount > 0 ? fmt::format("+{}", std::min(line->amount, 999)) : "";
    const PictureSize icon = panel.picture_size(line->picture);
    const int width = std::max(icon.width, kIconWidth) + static_cast<int>(text.size()) * kCharacterSide;
    panel.fill(0, y, width, kPickupHeight - 1, 0, kBackground * opacity);
    panel.draw_picture(line->picture, std::max(0, (kIconWidth - icon.width) / 2),
                       y + (kPickupHeight - 1 - icon.height) / 2, opacity);
    panel.draw_text(text, kIconWidth, y + kTextY, opacity);
  }
}

}  // namespace temblor::client
