#include "client/hud/layouts/player_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "client/hud/items.h"

namespace temblor::client {

namespace {

// Numbers at or below these are in the warning color.
constexpr int kLowHealth = 25, kLowArmor = 25, kLowAmmo = 10;
constexpr int kBarDigits = 3;
constexpr std::uint8_t kMarkColor = 15, kMarkEdge = 0;  // palette indices: white, black
// The armor number that an invulnerable player sees.
constexpr int kInvulnerableArmor = 666;

// Draws a number. With `marks_warning`, a low one gets an exclamation mark in the unused place of the
// hundreds, for players who do not see the warning color.
void draw_number(const Panel& panel, int value, int low_limit, int x, bool marks_warning) {
  const bool warns = value <= low_limit;
  panel.draw_number(value, kBarDigits, warns, x, 0);
  if (!warns || !marks_warning) return;
  constexpr int kStrokeX = 10, kStroke = 4;
  panel.fill(x + kStrokeX, 3, kStroke, 11, kMarkColor);
  panel.fill(x + kStrokeX, 17, kStroke, kStroke, kMarkColor);
}

// Draws one to three squares for the kind of armor.
void draw_armor_marks(const Panel& panel, int kind, int icon_x) {
  constexpr int kApart = 7, kSide = 4, kY = 19;
  for (int i = 0; i < kind; ++i) {
    panel.fill(icon_x + 2 + i * kApart - 1, kY - 1, kSide + 2, kSide + 2, kMarkEdge);
    panel.fill(icon_x + 2 + i * kApart, kY, kSide, kSide, kMarkColor);
  }
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

// The picture of the ammo that the weapon in hand uses; null: none.
const char* find_ammo_picture(const Game& game, assets::MissionPack pack) {
  for (const ItemIcon& kind : find_item_layout(pack).ammo)
    if (has_items(game, kind.item)) return kind.picture;
  return nullptr;
}

}  // namespace

bool has_items(const Game& game, std::uint32_t items) {
  return (game.data.items & items) == items;
}

void draw_health_number(const Panel& panel, int x, const Game& game, const BarLook& look) {
  draw_number(panel, game.stat(Stat::kHealth), kLowHealth, x, look.safe_colors);
}

void draw_ammo_number(const Panel& panel, int x, const Game& game, const BarLook& look) {
  draw_number(panel, game.stat(Stat::kAmmo), kLowAmmo, x, look.safe_colors);
}

void draw_armor(const Panel& panel, int x, const Game& game, const BarLook& look, double dropped_for_s) {
  // A player without armor need not be warned all the time.
  constexpr double kWarning_s = 3;
  const int number_x = x + kFigureIconWidth;
  if (has_items(game, kItemInvulnerability)) {
    panel.draw_number(kInvulnerableArmor, kBarDigits, true, number_x, 0);
    panel.draw_picture("disc", x, 0);
    return;
  }
  const int armor = game.stat(Stat::kArmor);
  draw_number(panel, armor, kLowArmor, number_x, look.safe_colors && dropped_for_s < kWarning_s);
  const int kind = find_armor_kind(game.data.items, look.pack);
  if (kind == 0) return;
  panel.draw_picture(kArmorPictures[static_cast<std::size_t>(kind) - 1], x, 0);
  if (look.safe_colors) draw_armor_marks(panel, kind, x);
}

bool uses_ammo(const Game& game, assets::MissionPack pack) {
  return find_ammo_picture(game, pack) != nullptr;
}

void draw_ammo(const Panel& panel, int x, const Game& game, const BarLook& look) {
  if (const char* const picture = find_ammo_picture(game, look.pack)) panel.draw_picture(picture, x, 0);
  draw_ammo_number(panel, x + kFigureIconWidth, game, look);
}

void draw_face(const Panel& panel, int x, const Game& game, bool in_pain) {
  panel.draw_picture(find_face_picture(game, in_pain), x, 0);
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

void draw_small_number(const Panel& panel, int number, int x, int y, float opacity) {
  constexpr std::uint8_t kSmallZero = 18;
  const std::string digits = align_right(std::max(number, 0), kBarDigits);
  for (std::size_t i = 0; i < digits.size(); ++i)
    if (digits[i] != ' ')
      panel.draw_character(static_cast<std::uint8_t>(kSmallZero + digits[i] - '0'),
                           x + static_cast<int>(i) * kCharacterSide, y, opacity);
}

std::uint32_t find_weapon_in_hand(const Game& game, assets::MissionPack pack) {
  const auto sent = static_cast<std::uint32_t>(game.stat(Stat::kActiveWeapon));
  if (pack == assets::MissionPack::kNone) return sent;
  return sent < 32 ? std::uint32_t{1} << sent : 0;
}

const char* find_rogue_picture(std::uint32_t in_hand, std::size_t slot) {
  constexpr const char* kPictures[] = {"r_lava", "r_superlava", "r_gren", "r_multirock", "r_plasma"};
  constexpr std::size_t kFirstSlot = 2;
  if (slot < kFirstSlot || slot - kFirstSlot >= std::size(kPictures)) return nullptr;
  const std::size_t weapon = slot - kFirstSlot;
  return in_hand == std::uint32_t{kRogueLavaNailgun} << weapon ? kPictures[weapon] : nullptr;
}

}  // namespace temblor::client
