// The items are those of stock game code, by their bits and fields, so that this works with any program that
// keeps them.
#include "server/commands/give.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "command/text.h"

namespace temblor::server {
namespace {

constexpr std::string_view kHelp =
    "give all; give weapons, ammo, keys; give 2 to 8: a weapon;\n"
    "give h, a, s, n, r, c NUMBER: health, armor, shells, nails, rockets, cells\n";

// Bits of `items`, as the status bar of every program shows them.
constexpr int kStockWeapons = 127, kAxe = 4096, kKeys = 131072 | 262144;
constexpr int kAnyArmor = 8192 | 16384 | 32768;
constexpr int kEighthWeapon = 128;  // only in programs that have one more than the stock ones

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
};
constexpr std::array<Ammunition, 4> kAmmunition = {
    Ammunition{'s', "shells", field::kAmmoShells, 100, 1 | 2},
    Ammunition{'n', "nails", field::kAmmoNails, 200, 4 | 8},
    Ammunition{'r', "rockets", field::kAmmoRockets, 100, 16 | 32},
    Ammunition{'c', "cells", field::kAmmoCells, 100, 64 | kEighthWeapon}};
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
  const bool has_eighth = game.machine().program().find_function("weapon_tremor") != vm::kNoFunction;
  return kStockWeapons | kAxe | (has_eighth ? kEighthWeapon : 0);
}

// The status bar shows currentammo, a copy of the count for the weapon in hand.
void give_ammunition(const Edict& player, const Ammunition& kind, float count) {
  player.set(kind.field, count);
  if ((player.whole(field::kWeapon) & kind.weapons) != 0) player.set(field::kCurrentAmmo, count);
}

void give_all_ammunition(const Edict& player) {
  for (const Ammunition& kind : kAmmunition) give_ammunition(player, kind, kind.full);
}

void give_armor(const Edict& player, float points) {
  player.set(field::kArmorValue, points);
  const auto kind = std::find_if(kArmors.begin(), kArmors.end(),
                                 [&](const Armor& armor) { return points >= armor.min_points; });
  const bool has_any = points > 0;
  player.set(field::kArmorType, has_any ? kind->absorbed : 0.0f);
  const int others = player.whole(field::kItems) & ~kAnyArmor;
  player.set(field::kItems, static_cast<float>(others | (has_any ? kind->item : 0)));
}

std::string give_everything(const Game& game, const Edict& player) {
  add_items(player, known_weapons(game) | kKeys);
  give_all_ammunition(player);
  give_armor(player, kFullArmor);
  player.set(field::kHealth, std::max(player[field::kHealth], kFullHealth));
  return "You have everything\n";
}

// Gives something that is counted, by its first letter. Empty: there is no such letter.
std::optional<std::string> give_some(const Edict& player, char letter, std::optional<float> count) {
  if (letter == 'h') {
    player.set(field::kHealth, std::max(count.value_or(kFullHealth), 1.0f));
    return fmt::format("You have {} health\n", player[field::kHealth]);
  }
  if (letter == 'a') {
    give_armor(player, count.value_or(kFullArmor));
    return fmt::format("You have {} armor\n", player[field::kArmorValue]);
  }
  for (const Ammunition& kind : kAmmunition) {
    if (kind.letter != letter) continue;
    give_ammunition(player, kind, count.value_or(kind.full));
    return fmt::format("You have {} {}\n", player[kind.field], kind.name);
  }
  return std::nullopt;
}

}  // namespace

std::string give(Game& io_game, std::size_t slot, std::span<const std::string> words) {
  if (words.size() < 2 || words[1].empty()) return std::string(kHelp);
  const Edict player = io_game.player(slot);
  if (!(player[field::kHealth] > 0)) return "You are dead\n";
  const std::string what = base::to_lower(words[1]);
  if (what == "all") return give_everything(io_game, player);
  if (what == "weapons") {
    add_items(player, known_weapons(io_game));
    return "You have all weapons\n";
  }
  if (what == "ammo") {
    give_all_ammunition(player);
    return "You have full ammunition\n";
  }
  if (what == "keys") {
    add_items(player, kKeys);
    return "You have the keys\n";
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
  if (std::optional<std::string> given = give_some(player, what[0], count)) return *given;
  return fmt::format("Cannot give \"{}\".\n{}", base::quotable(words[1]), kHelp);
}

}  // namespace temblor::server
