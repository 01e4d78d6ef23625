#include "client/hud/notices/weapon_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "client/hud/item_layout.h"
#include "client/hud/layouts/player_figures.h"

namespace temblor::client {

namespace {

constexpr double kListLasts_s = 1, kListFades_s = 0.3;
// From a weapon to the next one where there is room, so that the numbers stay apart.
constexpr int kCellWidth = 24, kCellStep = 28;

struct WeaponCell {
  std::string picture;
  int ammo;
  bool is_in_hand;
};
struct WeaponRow {
  // All weapons of a layout and those that share a place.
  std::array<WeaponCell, 16> cells;
  std::size_t count = 0;
};

// Weapons without a picture, such as the Tremor in stock data, are left out.
WeaponRow list_weapons(const Panel& panel, const Game& game, assets::MissionPack pack) {
  const std::uint32_t in_hand = find_weapon_in_hand(game, pack);
  const ItemLayout& layout = find_item_layout(pack);
  WeaponRow row;
  for (const std::span<const WeaponSlot> weapons : {layout.weapons, layout.extra_weapons})
    for (std::size_t slot = 0; slot < weapons.size() && row.count < row.cells.size(); ++slot) {
      const WeaponSlot& weapon = weapons[slot];
      if (!has_items(game, weapon.item)) continue;
      const char* const other =
          pack == assets::MissionPack::kRogue ? find_rogue_picture(in_hand, slot) : nullptr;
      const bool is_in_hand = in_hand == weapon.item || other != nullptr;
      std::string picture =
          other != nullptr ? other : fmt::format("{}_{}", is_in_hand ? "inv2" : "inv", weapon.name);
      if (panel.picture_size(picture).width > 0)
        row.cells[row.count++] = {std::move(picture), game.stat(weapon.ammo), is_in_hand};
    }
  return row;
}

// Draws a frame around the weapon in hand.
void draw_cell_frame(const Panel& panel, int x, int width, float opacity) {
  constexpr std::uint8_t kWhite = 15;
  panel.fill(x, -kWeaponListHeight, width, 1, kWhite, opacity);
  panel.fill(x, -1, width, 1, kWhite, opacity);
  panel.fill(x, 1 - kWeaponListHeight, 1, kWeaponListHeight - 2, kWhite, opacity);
  panel.fill(x + width - 1, 1 - kWeaponListHeight, 1, kWeaponListHeight - 2, kWhite, opacity);
}

}  // namespace

void WeaponList::begin_level() {
  changed_s_ = std::numeric_limits<double>::lowest();
  weapon_ = 0;
}

void WeaponList::advance(const Game& game, assets::MissionPack pack, double time_s, bool is_watched) {
  const std::uint32_t weapon = find_weapon_in_hand(game, pack);
  if (std::exchange(weapon_, weapon) != weapon && is_watched) changed_s_ = time_s;
}

bool WeaponList::is_shown(double time_s) const {
  return time_s - changed_s_ < kListLasts_s + kListFades_s;
}

void WeaponList::draw(const Panel& panel, const Game& game, assets::MissionPack pack, int max_width,
                      double time_s) const {
  constexpr int kIconY = 1 - kWeaponListHeight, kAmmoY = -9;
  constexpr float kBackground = 0.5f;
  const WeaponRow row = list_weapons(panel, game, pack);
  if (!is_shown(time_s) || row.count == 0) return;
  const double left_s = changed_s_ + kListLasts_s + kListFades_s - time_s;
  const auto opacity = static_cast<float>(std::clamp(left_s / kListFades_s, 0.0, 1.0));
  // The picture of the thunderbolt may be twice as wide. A weapon after it covers its right half.
  const auto gaps = static_cast<int>(row.count) - 1;
  const int last = std::max(kCellWidth, panel.picture_size(row.cells[row.count - 1].picture).width);
  const int step = gaps == 0 ? 0 : std::clamp((max_width - last) / gaps, 1, kCellStep);
  const int width = gaps * step + last;
  int x = -width / 2;
  panel.fill(x, -kWeaponListHeight, width, kWeaponListHeight, 0, kBackground * opacity);
  for (std::size_t i = 0; i < row.count; ++i, x += step) {
    const WeaponCell& cell = row.cells[i];
    panel.draw_picture(cell.picture, x, kIconY, opacity);
    draw_small_number(panel, cell.ammo, x, kAmmoY, opacity);
    if (cell.is_in_hand)
      draw_cell_frame(panel, x, i + 1 == row.count ? last : std::min(step, kCellWidth), opacity);
  }
}

}  // namespace temblor::client
