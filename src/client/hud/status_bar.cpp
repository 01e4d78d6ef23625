#include "client/hud/status_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>

#include "client/hud/item_layout.h"
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

// The pentagram replaces armor with the number 666 and a disc, as in the original. `armors`: the items of the
// three kinds, weakest first. `dropped_for_s`: how long ago armor was lost.
void draw_armor(const Panel& bar, const Game& game, std::span<const std::uint32_t, 3> armors,
                bool safe_colors, double dropped_for_s) {
  constexpr int kIconX = 0, kNumberX = 24;
  // A player without armor need not be warned all the time.
  constexpr double kWarning_s = 3;
  if (has_items(game, kItemInvulnerability)) {
    bar.draw_number(kInvulnerableArmor, kBarDigits, true, kNumberX, 0);
    bar.draw_picture("disc", kIconX, 0);
    return;
  }
  const int armor = game.stat(Stat::kArmor);
  draw_number(bar, armor, kLowArmor, kNumberX, safe_colors && dropped_for_s < kWarning_s);
  int kind = 3;
  while (kind > 0 && !has_items(game, armors[static_cast<std::size_t>(kind) - 1])) --kind;
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
void draw_ammo(const Panel& bar, const Game& game, std::span<const ItemIcon> kinds, bool safe_colors) {
  constexpr int kNumberX = 248;
  const auto kind =
      std::ranges::find_if(kinds, [&](const ItemIcon& icon) { return has_items(game, icon.item); });
  if (kind != kinds.end()) bar.draw_picture(kind->picture, kind->x, kind->y);
  draw_number(bar, game.stat(Stat::kAmmo), kLowAmmo, kNumberX, safe_colors);
}

void draw_icons(const Panel& panel, const Game& game, std::span<const ItemIcon> icons, bool safe_colors) {
  constexpr int kInIcon = 4;  // position of a mark
  for (const ItemIcon& icon : icons)
    if (has_items(game, icon.item)) panel.draw_picture(icon.picture, icon.x, icon.y);
  // After all pictures, because keys may overlap.
  for (const ItemIcon& icon : icons)
    if (safe_colors && icon.mark != 0 && has_items(game, icon.item))
      panel.draw_character(static_cast<std::uint8_t>(icon.mark), icon.x + kInIcon, icon.y + kInIcon);
}

// Returns the bit of the weapon in hand; 0: none. The servers of stock games send the bit itself, those of
// mission packs, whose bits do not fit in the message's byte, its index.
std::uint32_t find_weapon_in_hand(const Game& game, assets::MissionPack pack) {
  const auto sent = static_cast<std::uint32_t>(game.stat(Stat::kActiveWeapon));
  if (pack == assets::MissionPack::kNone) return sent;
  return sent < 32 ? std::uint32_t{1} << sent : 0;
}

// Whether a weapon that was picked up so long ago still flashes.
bool is_new(double held_s) {
  return held_s >= 0 && held_s < 1;
}

// Returns the icon of a weapon. For a second after the pickup it cycles through five bright pictures, ten a
// second. Later it is bright only for the weapon in hand.
std::string find_weapon_picture(const char* name, bool in_hand, double held_s) {
  constexpr double kPicturesPerSecond = 10;
  constexpr int kDifferent = 5;
  if (is_new(held_s))
    return fmt::format("inva{}_{}", static_cast<int>(held_s * kPicturesPerSecond) % kDifferent + 1, name);
  return fmt::format("{}_{}", in_hand ? "inv2" : "inv", name);
}

// The state of the weapons in a frame.
struct Arsenal {
  const Game& game;
  const HudTimes& times;
  double time_s;
  std::uint32_t in_hand;

  double held_s(std::uint32_t item) const {
    return time_s - times.item_gained_s[static_cast<std::size_t>(std::countr_zero(item))];
  }
  bool is_bright(std::uint32_t item) const { return in_hand == item || is_new(held_s(item)); }
  std::string picture(const WeaponSlot& slot) const {
    return find_weapon_picture(slot.name, in_hand == slot.item, held_s(slot.item));
  }
};

// Scourge of Armagon: a player with both launchers of grenades sees one picture of both in the place of the
// grenade launcher. It is bright on the side of the launcher that is in hand or new.
void draw_proximity_gun(const Panel& inventory, const Arsenal& arsenal) {
  constexpr int kX = 96, kY = 8;
  if (!has_items(arsenal.game, kHipnoticProximityGun)) return;
  const bool has_both = has_items(arsenal.game, kItemGrenadeLauncher);
  const WeaponSlot slot = has_both && arsenal.is_bright(kItemGrenadeLauncher)
                              ? WeaponSlot{kItemGrenadeLauncher, "gren_prox", kX}
                              : WeaponSlot{kHipnoticProximityGun, has_both ? "prox_gren" : "prox", kX};
  inventory.draw_picture(arsenal.picture(slot), slot.x, kY);
}

// Dissolution of Eternity: a weapon that fires its other ammo has another picture. It has no picture for the
// time after a pickup.
void draw_rogue_weapon(const Panel& inventory, std::uint32_t in_hand) {
  constexpr const char* kPictures[] = {"r_lava", "r_superlava", "r_gren", "r_multirock", "r_plasma"};
  constexpr int kWidth = 24, kFirstX = 48, kY = 8;
  for (std::size_t i = 0; i < std::size(kPictures); ++i)
    if (in_hand == std::uint32_t{kRogueLavaNailgun} << i)
      inventory.draw_picture(kPictures[i], kFirstX + kWidth * static_cast<int>(i), kY);
}

void draw_weapons(const Panel& inventory, const Arsenal& arsenal, assets::MissionPack pack) {
  constexpr int kY = 8;
  for (const WeaponSlot& slot : find_item_layout(pack).weapons)
    if (has_items(arsenal.game, slot.item)) inventory.draw_picture(arsenal.picture(slot), slot.x, kY);
  if (pack == assets::MissionPack::kHipnotic) draw_proximity_gun(inventory, arsenal);
  if (pack == assets::MissionPack::kRogue) draw_rogue_weapon(inventory, arsenal.in_hand);
}

// Dissolution of Eternity has two backgrounds, which name the ammo that the weapon in hand can fire.
void draw_background(const Panel& inventory, std::uint32_t in_hand, BarLook look) {
  constexpr std::uint32_t kOtherAmmo = kRogueLavaNailgun * 31u;  // the five weapons
  const char* const picture = (in_hand & kOtherAmmo) != 0 ? "r_invbar1" : "r_invbar2";
  const bool has_own = look.pack == assets::MissionPack::kRogue && inventory.has_picture(picture);
  inventory.draw_picture(has_own ? picture : "ibar", 0, 0, look.opacity);
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

// Dissolution of Eternity's games of teams with flags (teamplay 4 to 6) show the team's colors instead of the
// face.
bool shows_team_frame(const Panel& bar, const Game& game, BarLook look) {
  return look.pack == assets::MissionPack::kRogue && game.players.size() > 1 && look.teamplay >= 4 &&
         look.teamplay <= 6 && bar.has_picture(kTeamFramePicture);
}

}  // namespace

void draw_status_bar(const Panel& bar, const Game& game, const HudTimes& times, double time_s, BarLook look) {
  constexpr int kFaceX = 112, kHealthX = 136;
  const ItemLayout& layout = find_item_layout(look.pack);
  bar.draw_picture("sbar", 0, 0, look.opacity);
  draw_icons(bar, game, layout.bar, look.safe_colors);
  draw_armor(bar, game, layout.armors, look.safe_colors, time_s - times.armor_dropped_s);
  if (shows_team_frame(bar, game, look))
    draw_team_frame(bar, game);
  else
    bar.draw_picture(find_face_picture(game, time_s < times.pain_until_s), kFaceX, 0);
  draw_number(bar, game.stat(Stat::kHealth), kLowHealth, kHealthX, look.safe_colors);
  draw_ammo(bar, game, layout.ammo, look.safe_colors);
}

void draw_inventory(const Panel& inventory, const Game& game, const HudTimes& times, double time_s,
                    BarLook look) {
  const std::uint32_t in_hand = find_weapon_in_hand(game, look.pack);
  draw_background(inventory, in_hand, look);
  draw_weapons(inventory, {game, times, time_s, in_hand}, look.pack);
  draw_ammo_counts(inventory, game);
  draw_icons(inventory, game, find_item_layout(look.pack).inventory, look.safe_colors);
  if (game.deathmatch) draw_leaders(inventory, game);
}

}  // namespace temblor::client
