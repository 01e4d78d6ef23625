// Bits of net::ClientData::items for the status bar; power-ups are in client/session/powerups.h. Apart from
// the Tremor they are stock Quake's IT_ constants, which game code uses too.
#pragma once

#include <cstdint>

#include "client/session/powerups.h"

namespace temblor::client {

enum ItemBits : std::uint32_t {
  kItemShotgun = 1u << 0,  // weapons are consecutive bits up to kItemTremor
  kItemLightning = 1u << 6,
  kItemTremor = 1u << 7,  // our game's extra weapon, for which stock status bars have no picture
  kItemShells = 1u << 8,  // the ammo type of the current weapon
  kItemNails = 1u << 9,
  kItemRockets = 1u << 10,
  kItemCells = 1u << 11,
  kItemArmor1 = 1u << 13,
  kItemArmor2 = 1u << 14,
  kItemArmor3 = 1u << 15,
  kItemKey1 = 1u << 17,
  kItemKey2 = 1u << 18,
  kItemSigil1 = 1u << 28  // four consecutive bits
};

}  // namespace temblor::client
