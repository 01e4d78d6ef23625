#include "client/hud/status_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "client/hud/items.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

// Numbers at or below these warn.
constexpr int kLowHealth = 25, kLowArmor = 25, kLowAmmo = 10;
constexpr int kBarDigits = 3;
constexpr std::uint8_t kMarkColor = 15, kMarkEdge = 0;  // of the palette: white, black
// What the armor shows of the invulnerable.
constexpr int kInvulnerableArmor = 666;

bool has(const Game& game, std::uint32_t items) {
  return (game.data.items & items) == items;
}

// What warns, warns by shape too: an exclamation mark in the place of the hundreds, which are free then.
void draw_number(const Panel& bar, int value, int lowest_good, int x, bool marks_warning) {
  const bool warns = value <= lowest_good;
  bar.number(value, kBarDigits, warns, x, 0);
  if (!warns || !marks_warning) return;
  constexpr int kStrokeX = 10, kStroke = 4;
  bar.fill(x + kStrokeX, 3, kStroke, 11, kMarkColor);
  bar.fill(x + kStrokeX, 17, kStroke, kStroke, kMarkColor);
}

// As many squares as the armor is good.
void draw_armor_marks(const Panel& bar, int kind, int icon_x) {
  constexpr int kApart = 7, kSide = 4, kY = 19;
  for (int i = 0; i < kind; ++i) {
    bar.fill(icon_x + 2 + i * kApart - 1, kY - 1, kSide + 2, kSide + 2, kMarkEdge);
    bar.fill(icon_x + 2 + i * kApart, kY, kSide, kSide, kMarkColor);
  }
}

void draw_armor(const Panel& bar, const Game& game, bool safe_colors) {
  constexpr int kIconX = 0, kNumberX = 24;
  if (has(game, kItemInvulnerability)) {
    bar.number(kInvulnerableArmor, kBarDigits, true, kNumberX, 0);
    bar.picture("disc", kIconX, 0);
    return;
  }
  const int armor = game.stat(Stat::kArmor);
  draw_number(bar, armor, kLowArmor, kNumberX, safe_colors);
  const int kind = has(game, kItemArmor3) ? 3 : has(game, kItemArmor2) ? 2 : has(game, kItemArmor1) ? 1 : 0;
  if (kind == 0) return;
  bar.picture(fmt::format("sb_armor{}", kind), kIconX, 0);
  if (safe_colors) draw_armor_marks(bar, kind, kIconX);
}

// "face1" is that of full health, "face5" that of none; "face_p1" the same in pain.
std::string face_of(const Game& game, bool in_pain) {
  if (has(game, kItemInvisibility | kItemInvulnerability)) return "face_inv2";
  if (has(game, kItemQuad)) return "face_quad";
  if (has(game, kItemInvisibility)) return "face_invis";
  if (has(game, kItemInvulnerability)) return "face_invul2";
  constexpr int kHealthAFace = 20, kFaces = 5;
  const int fitness = std::clamp(game.stat(Stat::kHealth) / kHealthAFace, 0, kFaces - 1);
  return fmt::format("{}{}", in_pain ? "face_p" : "face", kFaces - fitness);
}

void draw_ammo(const Panel& bar, const Game& game, bool safe_colors) {
  constexpr int kIconX = 224, kNumberX = 248;
  if (has(game, kItemShells))
    bar.picture("sb_shells", kIconX, 0);
  else if (has(game, kItemNails))
    bar.picture("sb_nails", kIconX, 0);
  else if (has(game, kItemRockets))
    bar.picture("sb_rocket", kIconX, 0);
  else if (has(game, kItemCells))
    bar.picture("sb_cells", kIconX, 0);
  draw_number(bar, game.stat(Stat::kAmmo), kLowAmmo, kNumberX, safe_colors);
}

// For a second after it was found a weapon goes through five bright pictures, ten a second.
std::string weapon_picture(const char* name, bool in_hand, double held_s) {
  constexpr double kBrightPictures = 10, kPicturesASecond = 10;
  constexpr int kDifferent = 5;
  const double step = held_s * kPicturesASecond;
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
    if (!has(game, item)) continue;
    inventory.picture(weapon_picture(kNames[i], in_hand == item, time_s - times.item_gained_s[i]),
                      kWidth * static_cast<int>(i), kY);
  }
}

// In the small characters made for it.
void draw_ammo_counts(const Panel& inventory, const Game& game) {
  constexpr Stat kCounts[] = {Stat::kShells, Stat::kNails, Stat::kRockets, Stat::kCells};
  constexpr int kFirstX = 10, kApart = 48, kDigits = 3;
  constexpr std::uint8_t kSmallZero = 18;
  int x = kFirstX;
  for (const Stat stat : kCounts) {
    const std::string count = right_aligned(std::max(game.stat(stat), 0), kDigits);
    for (std::size_t i = 0; i < count.size(); ++i)
      if (count[i] != ' ')
        inventory.character(static_cast<std::uint8_t>(kSmallZero + count[i] - '0'),
                            x + static_cast<int>(i) * kCharacterSide, 0);
    x += kApart;
  }
}

void draw_finds(const Panel& inventory, const Game& game, bool safe_colors) {
  struct Find {
    std::uint32_t item;
    const char* picture;
    int x;
  };
  constexpr Find kFinds[] = {{kItemKey1, "sb_key1", 192},          {kItemKey2, "sb_key2", 208},
                             {kItemInvisibility, "sb_invis", 224}, {kItemInvulnerability, "sb_invuln", 240},
                             {kItemSuit, "sb_suit", 256},          {kItemQuad, "sb_quad", 272},
                             {kItemSigil1, "sb_sigil1", 288},      {kItemSigil1 << 1, "sb_sigil2", 296},
                             {kItemSigil1 << 2, "sb_sigil3", 304}, {kItemSigil1 << 3, "sb_sigil4", 312}};
  constexpr int kY = 8;
  for (const Find& find : kFinds)
    if (has(game, find.item)) inventory.picture(find.picture, find.x, kY);
  if (!safe_colors) return;
  constexpr int kInKey = 4;  // a letter in the middle of the picture: silver, gold
  if (has(game, kItemKey1)) inventory.character('S', kFinds[0].x + kInKey, kY + kInKey);
  if (has(game, kItemKey2)) inventory.character('G', kFinds[1].x + kInKey, kY + kInKey);
}

}  // namespace

void draw_status_bar(const Panel& bar, const Game& game, const HudTimes& times, double time_s, BarLook look) {
  constexpr int kFaceX = 112, kHealthX = 136;
  bar.picture("sbar", 0, 0, look.opacity);
  draw_armor(bar, game, look.safe_colors);
  bar.picture(face_of(game, time_s < times.pain_until_s), kFaceX, 0);
  draw_number(bar, game.stat(Stat::kHealth), kLowHealth, kHealthX, look.safe_colors);
  draw_ammo(bar, game, look.safe_colors);
}

void draw_inventory(const Panel& inventory, const Game& game, const HudTimes& times, double time_s,
                    BarLook look) {
  inventory.picture("ibar", 0, 0, look.opacity);
  draw_weapons(inventory, game, times, time_s);
  draw_ammo_counts(inventory, game);
  draw_finds(inventory, game, look.safe_colors);
  if (game.deathmatch) draw_leaders(inventory, game);
}

}  // namespace temblor::client
