#include "client/hud/item_layout.h"

#include "client/hud/items.h"

namespace temblor::client {

namespace {

constexpr int kWeaponWidth = 24;
constexpr int kInventoryIconY = 8;  // of the icons in the inventory

constexpr WeaponSlot weapon(int place, const char* name, Stat ammo) {
  return {std::uint32_t{kItemShotgun} << place, name, place * kWeaponWidth, ammo};
}
constexpr WeaponSlot kStockWeapons[] = {
    weapon(0, "shotgun", Stat::kShells),  weapon(1, "sshotgun", Stat::kShells),
    weapon(2, "nailgun", Stat::kNails),   weapon(3, "snailgun", Stat::kNails),
    weapon(4, "rlaunch", Stat::kRockets), weapon(5, "srlaunch", Stat::kRockets),
    weapon(6, "lightng", Stat::kCells),   weapon(7, "tremor", Stat::kCells)};
constexpr std::span kSharedWeapons = std::span(kStockWeapons).first(7);
// The laser covers the right half of the wide picture of the lightning gun.
constexpr WeaponSlot kHipnoticWeapons[] = {kStockWeapons[0],
                                           kStockWeapons[1],
                                           kStockWeapons[2],
                                           kStockWeapons[3],
                                           kStockWeapons[4],
                                           kStockWeapons[5],
                                           kStockWeapons[6],
                                           {kHipnoticLaserCannon, "laser", 176, Stat::kCells},
                                           {kHipnoticMjolnir, "mjolnir", 200, Stat::kCells}};

constexpr WeaponSlot kHipnoticExtraWeapons[] = {{kHipnoticProximityGun, "prox", 96, Stat::kRockets}};

constexpr ItemIcon kKeys[] = {{kItemKey1, "sb_key1", 192, kInventoryIconY, 'S'},
                              {kItemKey2, "sb_key2", 208, kInventoryIconY, 'G'}};
constexpr ItemIcon kPowerups[] = {{kItemInvisibility, "sb_invis", 224, kInventoryIconY},
                                  {kItemInvulnerability, "sb_invuln", 240, kInventoryIconY},
                                  {kItemSuit, "sb_suit", 256, kInventoryIconY},
                                  {kItemQuad, "sb_quad", 272, kInventoryIconY}};
constexpr ItemIcon kSigils[] = {{kItemSigil1, "sb_sigil1", 288, kInventoryIconY},
                                {kItemSigil1 << 1, "sb_sigil2", 296, kInventoryIconY},
                                {kItemSigil1 << 2, "sb_sigil3", 304, kInventoryIconY},
                                {kItemSigil1 << 3, "sb_sigil4", 312, kInventoryIconY}};
constexpr ItemIcon kStockIcons[] = {kKeys[0],     kKeys[1],   kPowerups[0], kPowerups[1], kPowerups[2],
                                    kPowerups[3], kSigils[0], kSigils[1],   kSigils[2],   kSigils[3]};
constexpr ItemIcon kHipnoticIcons[] = {kPowerups[0],
                                       kPowerups[1],
                                       kPowerups[2],
                                       kPowerups[3],
                                       {kHipnoticWetSuit, "sb_wsuit", 288, kInventoryIconY},
                                       {kHipnoticEmpathyShields, "sb_eshld", 304, kInventoryIconY},
                                       kSigils[0],
                                       kSigils[1],
                                       kSigils[2],
                                       kSigils[3]};
constexpr ItemIcon kRogueIcons[] = {kKeys[0],
                                    kKeys[1],
                                    kPowerups[0],
                                    kPowerups[1],
                                    kPowerups[2],
                                    kPowerups[3],
                                    {kRogueShield, "r_shield1", 288, kInventoryIconY},
                                    {kRogueAntigravity, "r_agrav1", 304, kInventoryIconY}};
// The weapons of this pack take the keys' place in the inventory.
constexpr ItemIcon kHipnoticKeys[] = {{kItemKey1, "sb_key1", 209, 3, 'S'},
                                      {kItemKey2, "sb_key2", 209, 12, 'G'}};

// The layouts place it.
constexpr ItemIcon ammo(std::uint32_t item, const char* picture) {
  return {item, picture, 0, 0};
}
constexpr ItemIcon kStockAmmo[] = {ammo(kItemShells, "sb_shells"), ammo(kItemNails, "sb_nails"),
                                   ammo(kItemRockets, "sb_rocket"), ammo(kItemCells, "sb_cells")};
// The last two pictures seem to be exchanged, but QuakeSpasm shows them so.
constexpr ItemIcon kRogueAmmo[] = {ammo(kRogueShells, "sb_shells"),         ammo(kRogueNails, "sb_nails"),
                                   ammo(kRogueRockets, "sb_rocket"),        ammo(kRogueCells, "sb_cells"),
                                   ammo(kRogueLavaNails, "r_ammolava"),     ammo(kRoguePlasma, "r_ammomulti"),
                                   ammo(kRogueMultiRockets, "r_ammoplasma")};

constexpr std::uint32_t kStockTimed = kItemInvisibility | kItemInvulnerability | kItemSuit | kItemQuad;

constexpr ItemLayout kStockLayout{
    kStockWeapons, {}, kStockIcons, {}, kStockAmmo, {kItemArmor1, kItemArmor2, kItemArmor3}, kStockTimed};
constexpr ItemLayout kHipnoticLayout{kHipnoticWeapons,
                                     kHipnoticExtraWeapons,
                                     kHipnoticIcons,
                                     kHipnoticKeys,
                                     kStockAmmo,
                                     {kItemArmor1, kItemArmor2, kItemArmor3},
                                     kStockTimed | kHipnoticWetSuit | kHipnoticEmpathyShields};
constexpr ItemLayout kRogueLayout{kSharedWeapons,
                                  {},
                                  kRogueIcons,
                                  {},
                                  kRogueAmmo,
                                  {kRogueArmor1, kRogueArmor2, kRogueArmor3},
                                  kStockTimed | kRogueShield | kRogueAntigravity};

}  // namespace

const ItemLayout& find_item_layout(assets::MissionPack pack) {
  switch (pack) {
    case assets::MissionPack::kHipnotic:
      return kHipnoticLayout;
    case assets::MissionPack::kRogue:
      return kRogueLayout;
    case assets::MissionPack::kNone:
      break;
  }
  return kStockLayout;
}

int find_armor_kind(std::uint32_t items, assets::MissionPack pack) {
  const auto& armors = find_item_layout(pack).armors;
  int kind = 3;
  while (kind > 0 && (items & armors[static_cast<std::size_t>(kind) - 1]) == 0) --kind;
  return kind;
}

}  // namespace temblor::client
