#include "client/hud/scoreboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string_view>

#include "base/check.h"

namespace temblor::client {

namespace {

constexpr int kFragDigits = 3;
constexpr std::uint8_t kOpeningBracket = 16, kClosingBracket = 17, kArrow = 13;

// Those who play, best first; where frags agree, in the order that they came. By number.
class Ranking {
 public:
  explicit Ranking(const Game& game) {
    CHECK(game.players.size() <= numbers_.size(), "{}", game.players.size());
    for (std::size_t i = 0; i < game.players.size(); ++i)
      if (!game.players[i].name.empty()) numbers_[count_++] = static_cast<std::uint8_t>(i);
    std::sort(numbers_.begin(), numbers_.begin() + count_, [&](std::uint8_t a, std::uint8_t b) {
      const int frags_a = game.players[a].frags, frags_b = game.players[b].frags;
      return frags_a != frags_b ? frags_a > frags_b : a < b;
    });
  }
  std::span<const std::uint8_t> players() const { return {numbers_.data(), count_}; }

 private:
  std::array<std::uint8_t, 255> numbers_{};  // serverinfo counts players in a byte
  std::size_t count_ = 0;
};

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
  constexpr int kNameMiddleX = 232, kCountDigits = 3;
  constexpr std::size_t kMostNameChars = 20;  // up to the counts on the left
  bar.picture("scorebar", 0, 0, opacity);
  const auto tally = [&](std::string_view label, Stat part, Stat whole, int y) {
    fmt::memory_buffer line;  // has room in itself, where a string of that length is on the heap
    fmt::format_to(std::back_inserter(line), "{}:{} /{}", label, right_aligned(game.stat(part), kCountDigits),
                   right_aligned(game.stat(whole), kCountDigits));
    bar.text({line.data(), line.size()}, kLeftX, y);
  };
  tally("Monsters", Stat::kMonsters, Stat::kTotalMonsters, kUpperY);
  tally("Secrets ", Stat::kSecrets, Stat::kTotalSecrets, kLowerY);
  const int seconds = static_cast<int>(std::clamp(time_s, 0.0, 59999.0));
  bar.text(fmt::format("Time :{:3}:{:02}", seconds / 60, seconds % 60), kTimeX, kUpperY);
  const std::string_view name = std::string_view(game.level_name).substr(0, kMostNameChars);
  bar.text(name, kNameMiddleX - static_cast<int>(name.size()) * kCharacterSide / 2, kLowerY);
}

void draw_leaders(const Panel& inventory, const Game& game) {
  constexpr std::size_t kShown = 4;
  constexpr int kFirstX = 194, kApart = 32, kWidth = 28, kHeight = 7;
  const Ranking ranking(game);
  int x = kFirstX;
  for (const std::size_t player : ranking.players().first(std::min(ranking.players().size(), kShown))) {
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
  const Ranking ranking(game);
  for (const std::size_t player : ranking.players()) {
    if (y + kCharacterSide > kScreenHeight) return;
    draw_frags(screen, game.players[player], {kFragsX, y, kFragsWidth, kCharacterSide});
    if (is_viewer(game, player)) screen.character(kArrow, kArrowX, y);
    screen.text(game.players[player].name, kNameX, y);
    y += kApart;
  }
}

}  // namespace temblor::client
