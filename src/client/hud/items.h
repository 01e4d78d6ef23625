// What net::ClientData::items says that the player has; power-ups are in client/session/powerups.h.
#pragma once

#include <cstdint>

#include "client/session/powerups.h"

namespace temblor::client {

enum ItemBits : std::uint32_t {
  kItemShotgun = 1u << 0,  // each weapon's bit is twice the one before: to kItemTremor
  kItemLightning = 1u << 6,
  kItemTremor = 1u << 7,  // of our own game: the extra weapon that stock status bars have no picture for
  kItemShells = 1u << 8,  // the ammunition that the weapon in hand takes
  kItemNails = 1u << 9,
  kItemRockets = 1u << 10,
  kItemCells = 1u << 11,
  kItemArmor1 = 1u << 13,
  kItemArmor2 = 1u << 14,
  kItemArmor3 = 1u << 15,
  kItemKey1 = 1u << 17,
  kItemKey2 = 1u << 18,
  kItemSigil1 = 1u << 28  // four of them, each bit twice the one before
};

}  // namespace temblor::client
