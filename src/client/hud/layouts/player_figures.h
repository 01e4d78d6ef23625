// The player's numbers and pictures of the HUD, which all layouts share: health, armor, ammo, weapons, items.
//
// Each figure is an icon of 24 x 24 of the original's pixels, and a number of three digits to its right.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "assets/mission_pack.h"
#include "client/hud/item_layout.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

constexpr int kFigureIconWidth = 24, kFigureWidth = 96, kFigureHeight = 24;

// How the figures are drawn.
struct BarLook {
  // Opacity of the status bar's background, 0 to 1.
  float opacity = 1;
  // Adds marks to warnings and to kinds of armor and keys.
  bool safe_colors = false;
  // Decides the items' bits and places.
  assets::MissionPack pack = assets::MissionPack::kNone;
  // The rule of that name.
  int teamplay = 0;
};

// Whether the player has all of these items.
bool has_items(const Game& game, std::uint32_t items);

// Draw numbers only. Low ones have the warning color, and with safe colors an exclamation mark.
void draw_health_number(const Panel& panel, int x, const Game& game, const BarLook& look);
void draw_ammo_number(const Panel& panel, int x, const Game& game, const BarLook& look);
// Draws icon and number. The pentagram replaces armor with the number 666 and a disc, as in the original.
// `dropped_for_s`: how long ago armor was lost.
void draw_armor(const Panel& panel, int x, const Game& game, const BarLook& look, double dropped_for_s);
// Draws icon and number. The server sends as a bit of the items which ammo the weapon in hand uses.
void draw_ammo(const Panel& panel, int x, const Game& game, const BarLook& look);
// Whether the weapon in hand uses ammo.
bool uses_ammo(const Game& game, assets::MissionPack pack);
void draw_face(const Panel& panel, int x, const Game& game, bool in_pain);
// Draws the pictures of the items that the player has, at their places.
void draw_icons(const Panel& panel, const Game& game, std::span<const ItemIcon> icons, bool safe_colors);
// Draws a number of up to three digits with the small digits of the character set.
void draw_small_number(const Panel& panel, int number, int x, int y, float opacity = 1);

// Returns the bit of the weapon in hand; 0: none. The servers of stock games send the bit itself, those of
// mission packs, whose bits do not fit in the message's byte, its index.
std::uint32_t find_weapon_in_hand(const Game& game, assets::MissionPack pack);
// Dissolution of Eternity: returns the picture of the weapon in hand if it fires its other ammo and takes the
// place of `slot` in ItemLayout::weapons; otherwise null.
const char* find_rogue_picture(std::uint32_t in_hand, std::size_t slot);

}  // namespace temblor::client
