#include "client/hud/scoreboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace temblor::client {

namespace {

constexpr int kFragDigits = 3;
constexpr std::uint8_t kOpeningBracket = 16, kClosingBracket = 17, kArrow = 13;

// Those who play, best first; where frags agree, in the order that they came. By number.
std::vector<std::size_t> ranked_players(const Game& game) {
  std::vector<std::size_t> ranked;
  for (std::size_t i = 0; i < game.players.size(); ++i)
    if (!game.players[i].name.empty()) ranked.push_back(i);
  std::stable_sort(ranked.begin(), ranked.end(), [&](std::size_t a, std::size_t b) {
    return game.players[a].frags > game.players[b].frags;
  });
  return ranked;
}

// A player is the entity of the number after his own.
bool is_viewer(const Game& game, std::size_t player) {
  return game.view_entity == player + 1;
}

// A row of the palette in a middle shade.
std::uint8_t shade_of(std::uint8_t colour) {
  constexpr int kRow = 16, kMiddle = 8;
  return static_cast<std::uint8_t>((colour & 15) * kRow + kMiddle);
}

struct Box {
  int x, y, width, height;
};

// Shirt over pants, and the frags on them.
void draw_frags(const Panel& panel, const Player& player, const Box& box) {
  const int upper = (box.height + 1) / 2;
  panel.fill(box.x, box.y, box.width, upper, shade_of(player.shirt));
  panel.fill(box.x, box.y + upper, box.width, box.height - upper, shade_of(player.pants));
  panel.text(right_aligned(player.frags, kFragDigits), box.x + (box.width - kFragDigits * kCharacterSide) / 2,
             box.y + box.height - kCharacterSide);
}

}  // namespace

void draw_level_scores(const Panel& bar, const Game& game, double time_s, float opacity) {
  constexpr int kUpperY = 4, kLowerY = 12, kLeftX = 8, kTimeX = 184;
  constexpr int kNameMiddleX = 232;
  constexpr std::size_t kMostNameChars = 20;  // up to the counts on the left
  bar.picture("scorebar", 0, 0, opacity);
  const auto count = [](Stat stat, const Game& of) { return right_aligned(of.stat(stat), 3); };
  bar.text(fmt::format("Monsters:{} /{}", count(Stat::kMonsters, game), count(Stat::kTotalMonsters, game)),
           kLeftX, kUpperY);
  bar.text(fmt::format("Secrets :{} /{}", count(Stat::kSecrets, game), count(Stat::kTotalSecrets, game)),
           kLeftX, kLowerY);
  const int seconds = static_cast<int>(std::clamp(time_s, 0.0, 59999.0));
  bar.text(fmt::format("Time :{:3}:{:02}", seconds / 60, seconds % 60), kTimeX, kUpperY);
  const std::string_view name = std::string_view(game.level_name).substr(0, kMostNameChars);
  bar.text(name, kNameMiddleX - static_cast<int>(name.size()) * kCharacterSide / 2, kLowerY);
}

void draw_leaders(const Panel& inventory, const Game& game) {
  constexpr std::size_t kShown = 4;
  constexpr int kFirstX = 194, kApart = 32, kWidth = 28, kHeight = 7;
  std::vector<std::size_t> ranked = ranked_players(game);
  if (ranked.size() > kShown) ranked.resize(kShown);
  int x = kFirstX;
  for (const std::size_t player : ranked) {
    draw_frags(inventory, game.players[player], {x, 1, kWidth, kHeight});
    if (is_viewer(game, player)) {
      inventory.character(kOpeningBracket, x - 4, 0);
      inventory.character(kClosingBracket, x + kWidth - 4, 0);
    }
    x += kApart;
  }
}

void draw_ranking(const Panel& screen, const Game& game) {
  constexpr int kTitleY = 8, kFirstY = 40, kApart = 10;
  constexpr int kFragsX = 80, kFragsWidth = 40, kArrowX = 128, kNameX = 144;
  screen.picture_in_middle("gfx/ranking.lmp", kTitleY);
  int y = kFirstY;
  for (const std::size_t player : ranked_players(game)) {
    if (y + kCharacterSide > kScreenHeight) return;
    draw_frags(screen, game.players[player], {kFragsX, y, kFragsWidth, kCharacterSide});
    if (is_viewer(game, player)) screen.character(kArrow, kArrowX, y);
    screen.text(game.players[player].name, kNameX, y);
    y += kApart;
  }
}

}  // namespace temblor::client
