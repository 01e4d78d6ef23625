#include "client/hud/status_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "client/hud/items.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

// Numbers at or below these are in the warning color.
constexpr int kLowHealth = 25, kLowArmor = 25, kLowAmmo = 10;
constexpr int kBarDigits = 3;
constexpr std::uint8_t kMarkColor = 15, kMarkEdge = 0;  // palette indices: white, black
// The armor number that an invulnerable player sees.
constexpr int kInvulnerableArmor = 666;

// Whether the player has all of these items.
bool has_items(const Game& game, std::uint32_t items) {
  return (game.data.items & items) == items;
}

// Draws a number. With `marks_warning`, a low one gets an exclamation mark in the unused place of the
// hundreds, for players who do not see the warning color.
void draw_number(const Panel& bar, int value, int low_limit, int x, bool marks_warning) {
  const bool warns = value <= low_limit;
  bar.draw_number(value, kBarDigits, warns, x, 0);
  if (!warns || !marks_warning) return;
  constexpr int kStrokeX = 10, kStroke = 4;
  bar.fill(x + kStrokeX, 3, kStroke, 11, kMarkColor);
  bar.fill(x + kStrokeX, 17, kStroke, kStroke, kMarkColor);
}

// Draws one to three squares for the kind of armor.
void draw_armor_marks(const Panel& bar, int kind, int icon_x) {
  constexpr int kApart = 7, kSide = 4, kY = 19;
  for (int i = 0; i < kind; ++i) {
    bar.fill(icon_x + 2 + i * kApart - 1, kY - 1, kSide + 2, kSide + 2, kMarkEdge);
    bar.fill(icon_x + 2 + i * kApart, kY, kSide, kSide, kMarkColor);
  }
}

// The pentagram replaces armor with the number 666 and a disc, as in the original.
void draw_armor(const Panel& bar, const Game& game, bool safe_colors) {
  constexpr int kIconX = 0, kNumberX = 24;
  if (has_items(game, kItemInvulnerability)) {
    bar.draw_number(kInvulnerableArmor, kBarDigits, true, kNumberX, 0);
    bar.draw_picture("disc", kIconX, 0);
    return;
  }
  const int armor = game.stat(Stat::kArmor);
  draw_number(bar, armor, kLowArmor, kNumberX, safe_colors);
  const int kind = has_items(game, kItemArmor3)   ? 3
                   : has_items(game, kItemArmor2) ? 2
                   : has_items(game, kItemArmor1) ? 1
                                                  : 0;
  if (kind == 0) return;
  bar.draw_picture(fmt::format("sb_armor{}", kind), kIconX, 0);
  if (safe_colors) draw_armor_marks(bar, kind, kIconX);
}

// Returns the picture of the face: "face1" is full health, "face5" nearly none; "face_p1" is the same in
// pain. Power-ups have faces of their own.
std::string find_face_picture(const Game& game, bool in_pain) {
  if (has_items(game, kItemInvisibility | kItemInvulnerability)) return "face_inv2";
  if (has_items(game, kItemQuad)) return "face_quad";
  if (has_items(game, kItemInvisibility)) return "face_invis";
  if (has_items(game, kItemInvulnerability)) return "face_invul2";
  constexpr int kHealthPerFace = 20, kFaces = 5;
  const int health_step = std::clamp(game.stat(Stat::kHealth) / kHealthPerFace, 0, kFaces - 1);
  return fmt::format("{}{}", in_pain ? "face_p" : "face", kFaces - health_step);
}

// The server sends which kind of ammo the weapon in hand uses as a bit of the items.
void draw_ammo(const Panel& bar, const Game& game, bool safe_colors) {
  constexpr int kIconX = 224, kNumberX = 248;
  if (has_items(game, kItemShells))
    bar.draw_picture("sb_shells", kIconX, 0);
  else if (has_items(game, kItemNails))
    bar.draw_picture("sb_nails", kIconX, 0);
  else if (has_items(game, kItemRockets))
    bar.draw_picture("sb_rocket", kIconX, 0);
  else if (has_items(game, kItemCells))
    bar.draw_picture("sb_cells", kIconX, 0);
  draw_number(bar, game.stat(Stat::kAmmo), kLowAmmo, kNumberX, safe_colors);
}

// Returns the icon of a weapon. For a second after the pickup it cycles through five bright pictures, ten a
// second. Later it is bright only for the weapon in hand.
std::string find_weapon_picture(const char* name, bool in_hand, double held_s) {
  constexpr double kBrightPictures = 10, kPicturesPerSecond = 10;
  constexpr int kDifferent = 5;
  const double step = held_s * kPicturesPerSecond;
  if (step >= 0 && step < kBrightPictures)
    return fmt::format("inva{}_{}", static_cast<int>(step) % kDifferent + 1, name);
  return fmt::format("{}_{}", in_hand ? "inv2" : "inv", name);
}

void draw_weapons(const Panel& inventory, const Game& game, const HudTimes& times, double time_s) {
  constexpr const char* kNames[] = {"shotgun", "sshotgun", "nailgun", "snailgun",
                                    "rlaunch", "srlaunch", "lightng", "tremor"};
  constexpr int kWidth = 24, kY = 8;
  const auto in_hand = static_cast<std::uint32_t>(game.stat(Stat::kActiveWeapon));
  for (std::size_t i = 0; i < std::size(kNames); ++i) {
    const std::uint32_t item = std::uint32_t{kItemShotgun} << i;
    if (!has_items(game, item)) continue;
    inventory.draw_picture(find_weapon_picture(kNames[i], in_hand == item, time_s - times.item_gained_s[i]),
                           kWidth * static_cast<int>(i), kY);
  }
}

// Uses the small digits of the character set.
void draw_ammo_counts(const Panel& inventory, const Game& game) {
  constexpr Stat kCounts[] = {Stat::kShells, Stat::kNails, Stat::kRockets, Stat::kCells};
  constexpr int kFirstX = 10, kApart = 48, kDigits = 3;
  constexpr std::uint8_t kSmallZero = 18;
  int x = kFirstX;
  for (const Stat stat : kCounts) {
    const std::string count = align_right(std::max(game.stat(stat), 0), kDigits);
    for (std::size_t i = 0; i < count.size(); ++i)
      if (count[i] != ' ')
        inventory.draw_character(static_cast<std::uint8_t>(kSmallZero + count[i] - '0'),
                                 x + static_cast<int>(i) * kCharacterSide, 0);
    x += kApart;
  }
}

// Draws the icons of keys, power-ups and sigils at their fixed places.
void draw_keys_and_powerups(const Panel& inventory, const Game& game, bool safe_colors) {
  struct Icon {
    std::uint32_t item;
    const char* picture;
    int x;
  };
  constexpr Icon kIcons[] = {{kItemKey1, "sb_key1", 192},          {kItemKey2, "sb_key2", 208},
                             {kItemInvisibility, "sb_invis", 224}, {kItemInvulnerability, "sb_invuln", 240},
                             {kItemSuit, "sb_suit", 256},          {kItemQuad, "sb_quad", 272},
                             {kItemSigil1, "sb_sigil1", 288},      {kItemSigil1 << 1, "sb_sigil2", 296},
                             {kItemSigil1 << 2, "sb_sigil3", 304}, {kItemSigil1 << 3, "sb_sigil4", 312}};
  constexpr int kY = 8;
  for (const Icon& icon : kIcons)
    if (has_items(game, icon.item)) inventory.draw_picture(icon.picture, icon.x, kY);
  if (!safe_colors) return;
  constexpr int kInKey = 4;  // position of a letter in the icon: S for silver, G for gold
  if (has_items(game, kItemKey1)) inventory.draw_character('S', kIcons[0].x + kInKey, kY + kInKey);
  if (has_items(game, kItemKey2)) inventory.draw_character('G', kIcons[1].x + kInKey, kY + kInKey);
}

}  // namespace

void draw_status_bar(const Panel& bar, const Game& game, const HudTimes& times, double time_s, BarLook look) {
  constexpr int kFaceX = 112, kHealthX = 136;
  bar.draw_picture("sbar", 0, 0, look.opacity);
  draw_armor(bar, game, look.safe_colors);
  bar.draw_picture(find_face_picture(game, time_s < times.pain_until_s), kFaceX, 0);
  draw_number(bar, game.stat(Stat::kHealth), kLowHealth, kHealthX, look.safe_colors);
  draw_ammo(bar, game, look.safe_colors);
}

void draw_inventory(const Panel& inventory, const Game& game, const HudTimes& times, double time_s,
                    BarLook look) {
  inventory.draw_picture("ibar", 0, 0, look.opacity);
  draw_weapons(inventory, game, times, time_s);
  draw_ammo_counts(inventory, game);
  draw_keys_and_powerups(inventory, game, look.safe_colors);
  if (game.deathmatch) draw_leaders(inventory, game);
}

}  // namespace temblor::client
