#include "client/hud/layouts/status_bar.h"

#include <fmt/format.h>

#include <bit>
#include <string>

#include "client/hud/item_layout.h"
#include "client/hud/items.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

// Whether a weapon that was picked up so long ago still flashes.
bool is_new(double held_s) {
  return held_s >= 0 && held_s < 1;
}

// Returns the icon of a weapon. For a second after the pickup it cycles through five bright pictures, ten a
// second. Later it is bright only for the weapon in hand.
std::string find_weapon_picture(const char* name, bool in_hand, double held_s) {
  constexpr double kPicturesPerSecond = 10;
  constexpr int kDifferent = 5;
  if (is_new(held_s))
    return fmt::format("inva{}_{}", static_cast<int>(held_s * kPicturesPerSecond) % kDifferent + 1, name);
  return fmt::format("{}_{}", in_hand ? "inv2" : "inv", name);
}

// The state of the weapons in a frame.
struct Arsenal {
  const Game& game;
  const HudTimes& times;
  double time_s;
  std::uint32_t in_hand;

  double held_s(std::uint32_t item) const {
    return time_s - times.item_gained_s[static_cast<std::size_t>(std::countr_zero(item))];
  }
  bool is_bright(std::uint32_t item) const { return in_hand == item || is_new(held_s(item)); }
  std::string picture(const WeaponSlot& slot) const {
    return find_weapon_picture(slot.name, in_hand == slot.item, held_s(slot.item));
  }
};

// Scourge of Armagon: a player with both launchers of grenades sees one picture of both in the place of the
// grenade launcher. It is bright on the side of the launcher that is in hand or new.
void draw_proximity_gun(const Panel& inventory, const Arsenal& arsenal) {
  constexpr int kX = 96, kY = 8;
  if (!has_items(arsenal.game, kHipnoticProximityGun)) return;
  const bool has_both = has_items(arsenal.game, kItemGrenadeLauncher);
  const WeaponSlot slot =
      has_both && arsenal.is_bright(kItemGrenadeLauncher)
          ? WeaponSlot{kItemGrenadeLauncher, "gren_prox", kX, Stat::kRockets}
          : WeaponSlot{kHipnoticProximityGun, has_both ? "prox_gren" : "prox", kX, Stat::kRockets};
  inventory.draw_picture(arsenal.picture(slot), slot.x, kY);
}

// Dissolution of Eternity: a weapon that fires its other ammo has another picture. It has no picture for the
// time after a pickup.
void draw_rogue_weapon(const Panel& inventory, std::uint32_t in_hand) {
  constexpr int kY = 8;
  const std::span<const WeaponSlot> slots = find_item_layout(assets::MissionPack::kRogue).weapons;
  for (std::size_t slot = 0; slot < slots.size(); ++slot)
    if (const char* const picture = find_rogue_picture(in_hand, slot))
      inventory.draw_picture(picture, slots[slot].x, kY);
}

void draw_weapons(const Panel& inventory, const Arsenal& arsenal, assets::MissionPack pack) {
  constexpr int kY = 8;
  for (const WeaponSlot& slot : find_item_layout(pack).weapons)
    if (has_items(arsenal.game, slot.item)) inventory.draw_picture(arsenal.picture(slot), slot.x, kY);
  if (pack == assets::MissionPack::kHipnotic) draw_proximity_gun(inventory, arsenal);
  if (pack == assets::MissionPack::kRogue) draw_rogue_weapon(inventory, arsenal.in_hand);
}

// Dissolution of Eternity has two backgrounds, which name the ammo that the weapon in hand can fire.
void draw_background(const Panel& inventory, std::uint32_t in_hand, const BarLook& look) {
  const char* const picture = (in_hand & kRogueOtherWeapons) != 0 ? "r_invbar1" : "r_invbar2";
  const bool has_own = look.pack == assets::MissionPack::kRogue && inventory.has_picture(picture);
  inventory.draw_picture(has_own ? picture : "ibar", 0, 0, look.opacity);
}

void draw_ammo_counts(const Panel& inventory, const Game& game) {
  constexpr Stat kCounts[] = {Stat::kShells, Stat::kNails, Stat::kRockets, Stat::kCells};
  constexpr int kFirstX = 10, kApart = 48;
  int x = kFirstX;
  for (const Stat stat : kCounts) {
    draw_small_number(inventory, game.stat(stat), x, 0);
    x += kApart;
  }
}

// Dissolution of Eternity's games of teams with flags (teamplay 4 to 6) show the team's colors instead of the
// face.
bool shows_team_frame(const Panel& bar, const Game& game, const BarLook& look) {
  return look.pack == assets::MissionPack::kRogue && game.players.size() > 1 && look.teamplay >= 4 &&
         look.teamplay <= 6 && bar.has_picture(kTeamFramePicture);
}

}  // namespace

void draw_status_bar(const Panel& bar, const Game& game, const HudTimes& times, double time_s,
                     const BarLook& look) {
  constexpr int kArmorX = 0, kFaceX = 112, kHealthX = 136, kAmmoX = 224;
  bar.draw_picture("sbar", 0, 0, look.opacity);
  draw_icons(bar, game, find_item_layout(look.pack).bar, look.safe_colors);
  draw_armor(bar, kArmorX, game, look, time_s - times.armor_dropped_s);
  if (shows_team_frame(bar, game, look))
    draw_team_frame(bar, game);
  else
    draw_face(bar, kFaceX, game, time_s < times.pain_until_s);
  draw_health_number(bar, kHealthX, game, look);
  draw_ammo(bar, kAmmoX, game, look);
}

void draw_inventory(const Panel& inventory, const Game& game, const HudTimes& times, double time_s,
                    const BarLook& look) {
  const std::uint32_t in_hand = find_weapon_in_hand(game, look.pack);
  draw_background(inventory, in_hand, look);
  draw_weapons(inventory, {game, times, time_s, in_hand}, look.pack);
  draw_ammo_counts(inventory, game);
  draw_icons(inventory, game, find_item_layout(look.pack).inventory, look.safe_colors);
  if (game.deathmatch) draw_leaders(inventory, game);
}

}  // namespace temblor::client
