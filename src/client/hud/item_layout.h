// Where the status bar and the inventory show the items of stock Quake and of the mission packs. Bits and
// places are those that QuakeSpasm shows.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "assets/mission_pack.h"
#include "client/session/client_state.h"

namespace temblor::client {

// A weapon that has pictures of its own in each state: "inv_NAME", "inv2_NAME", "inva1_NAME" and so on.
struct WeaponSlot {
  std::uint32_t item;
  const char* name;
  int x;  // in the inventory
  Stat ammo;
};

// An item that is shown by one picture. If the player has it, the picture is drawn.
struct ItemIcon {
  std::uint32_t item;
  const char* picture;
  int x, y;
  char mark = 0;  // a letter on it for safe colors; 0: none
};

// Parts of a pack that are drawn by rules of their own are in layouts/status_bar.cpp.
struct ItemLayout {
  std::span<const WeaponSlot> weapons;
  std::span<const WeaponSlot> extra_weapons;  // those that share a place with one of `weapons`
  std::span<const ItemIcon> inventory;        // keys, power-ups, and sigils
  std::span<const ItemIcon> bar;              // keys in the status bar
  std::span<const ItemIcon> ammo;             // in the status bar; only the first that the player has
  std::array<std::uint32_t, 3> armors;        // weakest first
  std::uint32_t timed;                        // items of `inventory` that last 30 seconds
};

const ItemLayout& find_item_layout(assets::MissionPack pack);

// The pictures of the kinds of armor, weakest first.
constexpr std::array kArmorPictures = {"sb_armor1", "sb_armor2", "sb_armor3"};
// The best kind of armor among the items, 1 to 3; 0: none.
int find_armor_kind(std::uint32_t items, assets::MissionPack pack);

}  // namespace temblor::client
