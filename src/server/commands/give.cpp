// The items are those of stock game code, by their bits and fields, so that this works with any program that
// keeps them.
#include "server/commands/give.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/text.h"
#include "command/text.h"
#include "server/game/baselines.h"

namespace temblor::server {
namespace {

constexpr std::string_view kHelp =
    "give all; give weapons, ammo, keys; give 2 to 8: a weapon;\n"
    "give h, a, s, n, r, c NUMBER: health, armor, shells, nails, rockets, cells\n";
constexpr std::string_view kHipnoticHelp = "give 6a, 9, 0: proximity launcher, laser cannon, Mjolnir\n";
constexpr std::string_view kRogueHelp = "give l, m, p NUMBER: lava nails, multi-rockets, plasma\n";

// Bits of `items`, as the status bar of every program shows them.
constexpr int kStockWeapons = 127, kAxe = 4096, kKeys = 131072 | 262144;
constexpr int kAnyArmor = 8192 | 16384 | 32768;
constexpr int kEighthWeapon = 128;  // only in programs that have one more than the stock ones
// Mission packs.
constexpr int kMjolnir = 128, kProximityGun = 65536, kLaserCannon = 8388608;
constexpr int kRogueAxe = 2048, kRogueAnyArmor = 1 | 2 | 4;  // the armor is in items2
constexpr int kLightning = 64;  // weapons of Dissolution of Eternity above it fire other ammunition

constexpr std::array<std::string_view, 7> kWeaponNames = {
    "shotgun",          "double-barreled shotgun", "nailgun",    "super nailgun",
    "grenade launcher", "rocket launcher",         "Thunderbolt"};

// A kind of ammunition, and the letter that players type for it.
struct Ammunition {
  char letter;
  std::string_view name;
  Field<float> field;
  float full;   // the amount without a number
  int weapons;  // bits of the weapons that fire it
  // Dissolution of Eternity keeps two kinds of ammunition for each kind of weapon in fields of its own, and
  // copies that of the weapon in hand to `field`.
  std::string_view pack_field{};
};
constexpr std::array kAmmunition = {Ammunition{'s', "shells", field::kAmmoShells, 100, 1 | 2},
                                    Ammunition{'n', "nails", field::kAmmoNails, 200, 4 | 8},
                                    Ammunition{'r', "rockets", field::kAmmoRockets, 100, 16 | 32},
                                    Ammunition{'c', "cells", field::kAmmoCells, 100, 64 | kEighthWeapon}};
constexpr std::array kHipnoticAmmunition = {
    kAmmunition[0], kAmmunition[1],
    Ammunition{'r', "rockets", field::kAmmoRockets, 100, 16 | 32 | kProximityGun},
    Ammunition{'c', "cells", field::kAmmoCells, 100, 64 | kMjolnir | kLaserCannon}};
constexpr std::array kRogueAmmunition = {
    Ammunition{'s', "shells", field::kAmmoShells, 100, 1 | 2, "ammo_shells1"},
    Ammunition{'n', "nails", field::kAmmoNails, 200, 4 | 8, "ammo_nails1"},
    Ammunition{'l', "lava nails", field::kAmmoNails, 200, 4096 | 8192, "ammo_lava_nails"},
    Ammunition{'r', "rockets", field::kAmmoRockets, 100, 16 | 32, "ammo_rockets1"},
    Ammunition{'m', "multi-rockets", field::kAmmoRockets, 100, 16384 | 32768, "ammo_multi_rockets"},
    Ammunition{'c', "cells", field::kAmmoCells, 100, 64, "ammo_cells1"},
    Ammunition{'p', "plasma", field::kAmmoCells, 100, 65536, "ammo_plasma"}};
constexpr float kFullHealth = 100, kFullArmor = 200;
constexpr float kMaxAmount = 999;  // the status bar has three digits

// The kinds of armor, strongest first, with the lowest number of points that counts as each.
struct Armor {
  float min_points, absorbed;  // `absorbed`: share of damage
  int item;
};
constexpr std::array<Armor, 3> kArmors = {Armor{151, 0.8f, 32768}, Armor{101, 0.6f, 16384},
                                          Armor{0, 0.3f, 8192}};

void add_items(const Edict& player, int items) {
  player.set(field::kItems, static_cast<float>(player.whole(field::kItems) | items));
}

// The weapons that the program knows. Our eighth weapon has a class of its own.
int known_weapons(const Game& game) {
  if (game.mission_pack() == assets::MissionPack::kHipnotic)
    return kStockWeapons | kAxe | kMjolnir | kProximityGun | kLaserCannon;
  if (game.mission_pack() == assets::MissionPack::kRogue) return kStockWeapons | kRogueAxe;
  const bool has_eighth = game.machine().program().find_function("weapon_tremor") != vm::kNoFunction;
  return kStockWeapons | kAxe | (has_eighth ? kEighthWeapon : 0);
}

std::span<const Ammunition> list_ammunition(const Game& game) {
  if (game.mission_pack() == assets::MissionPack::kHipnotic) return kHipnoticAmmunition;
  if (game.mission_pack() == assets::MissionPack::kRogue) return kRogueAmmunition;
  return kAmmunition;
}

// The status bar shows currentammo, a copy of the count for the weapon in hand.
void give_ammunition(const Game& game, const Edict& player, const Ammunition& kind, float count) {
  const int in_hand = player.whole(field::kWeapon);
  bool is_copied = true;
  if (!kind.pack_field.empty()) {
    if (const auto own = float_field(game.machine().program(), kind.pack_field)) player.set(*own, count);
    is_copied = (in_hand > kLightning && in_hand != kRogueAxe) == (kind.weapons > kLightning);
  }
  if (is_copied) player.set(kind.field, count);
  if ((in_hand & kind.weapons) != 0) player.set(field::kCurrentAmmo, count);
}

void give_all_ammunition(const Game& game, const Edict& player) {
  for (const Ammunition& kind : list_ammunition(game)) give_ammunition(game, player, kind, kind.full);
}

// Replaces the player's kind of armor. `item`: the stock bit; 0: no armor.
void set_armor_item(const Game& game, const Edict& player, int item) {
  constexpr int kFirstArmor = 8192;
  const auto items2 = game.items2_field();
  const bool is_rogue = game.mission_pack() == assets::MissionPack::kRogue && items2;
  const Field<float> field = is_rogue ? *items2 : field::kItems;
  const int others = player.whole(field) & ~(is_rogue ? kRogueAnyArmor : kAnyArmor);
  player.set(field, static_cast<float>(others | (is_rogue ? item / kFirstArmor : item)));
}

void give_armor(const Game& game, const Edict& player, float points) {
  player.set(field::kArmorValue, points);
  const auto kind = std::find_if(kArmors.begin(), kArmors.end(),
                                 [&](const Armor& armor) { return points >= armor.min_points; });
  const bool has_any = points > 0;
  player.set(field::kArmorType, has_any ? kind->absorbed : 0.0f);
  set_armor_item(game, player, has_any ? kind->item : 0);
}

std::string give_everything(const Game& game, const Edict& player) {
  add_items(player, known_weapons(game) | kKeys);
  give_all_ammunition(game, player);
  give_armor(game, player, kFullArmor);
  player.set(field::kHealth, std::max(player[field::kHealth], kFullHealth));
  return "You have everything\n";
}

// Gives something that is counted, by its first letter. Empty: there is no such letter.
std::optional<std::string> give_some(const Game& game, const Edict& player, char letter,
                                     std::optional<float> count) {
  if (letter == 'h') {
    player.set(field::kHealth, std::max(count.value_or(kFullHealth), 1.0f));
    return fmt::format("You have {} health\n", player[field::kHealth]);
  }
  if (letter == 'a') {
    give_armor(game, player, count.value_or(kFullArmor));
    return fmt::format("You have {} armor\n", player[field::kArmorValue]);
  }
  for (const Ammunition& kind : list_ammunition(game)) {
    if (kind.letter != letter) continue;
    const float given = count.value_or(kind.full);
    give_ammunition(game, player, kind, given);
    return fmt::format("You have {} {}\n", given, kind.name);
  }
  return std::nullopt;
}

struct HipnoticWeapon {
  std::string_view word, name;
  int item;
};

// Null: there is no such weapon, or this is another game.
const HipnoticWeapon* find_hipnotic_weapon(const Game& game, std::string_view word) {
  static constexpr HipnoticWeapon kWeapons[] = {{"6a", "proximity launcher", kProximityGun},
                                                {"9", "laser cannon", kLaserCannon},
                                                {"0", "Mjolnir", kMjolnir}};
  if (game.mission_pack() != assets::MissionPack::kHipnotic) return nullptr;
  for (const HipnoticWeapon& weapon : kWeapons)
    if (weapon.word == word) return &weapon;
  return nullptr;
}

std::string make_help(const Game& game) {
  std::string help(kHelp);
  if (game.mission_pack() == assets::MissionPack::kHipnotic) help += kHipnoticHelp;
  if (game.mission_pack() == assets::MissionPack::kRogue) help += kRogueHelp;
  return help;
}

}  // namespace

std::string give(Game& io_game, std::size_t slot, std::span<const std::string> words) {
  if (words.size() < 2 || words[1].empty()) return make_help(io_game);
  const Edict player = io_game.player(slot);
  if (!(player[field::kHealth] > 0)) return "You are dead\n";
  const std::string what = base::to_lower(words[1]);
  if (what == "all") return give_everything(io_game, player);
  if (what == "weapons") {
    add_items(player, known_weapons(io_game));
    return "You have all weapons\n";
  }
  if (what == "ammo") {
    give_all_ammunition(io_game, player);
    return "You have full ammunition\n";
  }
  if (what == "keys") {
    add_items(player, kKeys);
    return "You have the keys\n";
  }
  if (const HipnoticWeapon* const weapon = find_hipnotic_weapon(io_game, what)) {
    add_items(player, weapon->item);
    return fmt::format("You have the {}\n", weapon->name);
  }
  if (what.size() == 1 && what[0] >= '2' && what[0] <= '8') {
    const auto number = static_cast<std::size_t>(what[0] - '2');
    add_items(player, 1 << number);
    return fmt::format("You have the {}\n", kWeaponNames[number]);
  }
  std::optional<float> count;
  if (words.size() > 2) {
    const std::optional<std::int64_t> number = command::parse_whole_number(words[2]);
    if (!number)
      return fmt::format("give {} NUMBER: \"{}\" is not a whole number\n", base::quotable(words[1]),
                         base::quotable(words[2]));
    count = static_cast<float>(std::clamp<std::int64_t>(*number, 0, static_cast<std::int64_t>(kMaxAmount)));
  }
  if (std::optional<std::string> given = give_some(io_game, player, what[0], count)) return *given;
  return fmt::format("Cannot give \"{}\".\n{}", base::quotable(words[1]), make_help(io_game));
}

}  // namespace temblor::server
