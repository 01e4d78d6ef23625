// Bits of net::ClientData::items for the status bar; power-ups are in client/session/powerups.h. Apart from
// the Tremor they are the constants of the original games (IT_, HIT_, RIT_), which game code uses too.
#pragma once

#include <cstdint>

#include "client/session/powerups.h"

namespace temblor::client {

enum ItemBits : std::uint32_t {
  kItemShotgun = 1u << 0,  // weapons are consecutive bits up to kItemTremor
  kItemGrenadeLauncher = 1u << 4,
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

// The bits of Scourge of Armagon that differ. Those from 23 on come from the field items2.
enum HipnoticItemBits : std::uint32_t {
  kHipnoticMjolnir = 1u << 7,
  kHipnoticProximityGun = 1u << 16,
  kHipnoticLaserCannon = 1u << 23,
  kHipnoticWetSuit = 1u << 24,
  kHipnoticEmpathyShields = 1u << 25
};

// The bits of Dissolution of Eternity that differ.
enum RogueItemBits : std::uint32_t {
  kRogueShells = 1u << 7,
  kRogueNails = 1u << 8,
  kRogueRockets = 1u << 9,
  kRogueCells = 1u << 10,
  kRogueLavaNailgun = 1u << 12,  // the first of five weapons with other ammo, in consecutive bits
  kRogueOtherWeapons = 31u << 12,
  kRogueArmor1 = 1u << 23,
  kRogueArmor2 = 1u << 24,
  kRogueArmor3 = 1u << 25,
  kRogueLavaNails = 1u << 26,
  kRoguePlasma = 1u << 27,
  kRogueMultiRockets = 1u << 28,
  kRogueShield = 1u << 29,
  kRogueAntigravity = 1u << 30
};

}  // namespace temblor::client
