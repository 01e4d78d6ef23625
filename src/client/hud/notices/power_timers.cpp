#include "client/hud/notices/power_timers.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "client/hud/item_layout.h"
#include "client/hud/layouts/player_figures.h"

namespace temblor::client {

namespace {

constexpr double kPowerLasts_s = 30, kMaxShown_s = 99;
constexpr int kPowerSide = 16;

// The seconds that are left as text; empty if there are none or more than two digits. The last five are in
// the second color of the characters.
std::string format_seconds(double left_s) {
  constexpr double kLast_s = 5;
  constexpr int kSecondColor = 128;
  if (!(left_s > 0 && left_s <= kMaxShown_s)) return {};
  std::string text = fmt::format("{}", static_cast<int>(std::ceil(left_s)));
  if (left_s <= kLast_s)
    for (char& digit : text) digit = static_cast<char>(digit + kSecondColor);
  return text;
}

}  // namespace

void PowerTimers::begin_level() {
  items_ = 0;
  gained_s_.fill(std::numeric_limits<double>::lowest());
}

void PowerTimers::advance(const Game& game, double time_s, bool is_watched) {
  const std::uint32_t gained = game.data.items & ~items_;
  items_ = game.data.items;
  constexpr double kUnknown = std::numeric_limits<double>::lowest();
  for (std::size_t bit = 0; bit < gained_s_.size(); ++bit)
    if ((gained >> bit & 1) != 0) gained_s_[bit] = is_watched ? time_s : kUnknown;
}

void PowerTimers::draw(const Panel& panel, const Game& game, assets::MissionPack pack, double time_s) const {
  constexpr float kBackground = 0.4f;
  const ItemLayout& layout = find_item_layout(pack);
  int y = 0;
  for (const ItemIcon& icon : layout.inventory) {
    if ((icon.item & layout.timed) == 0 || !has_items(game, icon.item)) continue;
    y -= kPowerTimerHeight;
    const auto bit = static_cast<std::size_t>(std::countr_zero(icon.item));
    const double sent_s = game.powerup_ends_s[bit];
    const double since_s = time_s - gained_s_[bit];
    const double estimate_s = since_s >= 0 ? kPowerLasts_s - since_s : 0;
    const std::string text = format_seconds(sent_s != 0 ? sent_s - time_s : estimate_s);
    const int text_width = static_cast<int>(text.size()) * kCharacterSide;
    panel.fill(-kPowerSide - text_width - 1, y, kPowerSide + text_width + 1, kPowerTimerHeight - 1, 0,
               kBackground);
    panel.draw_picture(icon.picture, -kPowerSide, y);
    panel.draw_text(text, -kPowerSide - text_width, y + (kPowerSide - kCharacterSide) / 2);
  }
}

}  // namespace temblor::client
