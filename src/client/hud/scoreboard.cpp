#include "client/hud/scoreboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "base/check.h"

namespace temblor::client {

namespace {

constexpr int kFragDigits = 3;
// Character codes.
constexpr std::uint8_t kOpeningBracket = 16, kClosingBracket = 17, kArrow = 13;

// The numbers of the active players, best first; equal scores are in order of joining.
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
  std::array<std::uint8_t, 255> numbers_{};  // serverinfo has the number of players in a byte
  std::size_t count_ = 0;
};

// A player's entity number is the player number plus 1.
bool is_viewer(const Game& game, std::size_t player) {
  return game.view_entity == player + 1;
}

// The middle shade of a palette row; player colors are rows.
std::uint8_t get_middle_shade(std::uint8_t color) {
  constexpr int kRow = 16, kMiddle = 8;
  return static_cast<std::uint8_t>((color & 15) * kRow + kMiddle);
}

// A box for a player's colors and frags, in the panel's pixels.
struct ScoreBox {
  int x, y, width, height;
};

// Draws the shirt color above the pants color, and the frags on them.
void draw_frags(const Panel& panel, const Player& player, const ScoreBox& box) {
  const int upper = (box.height + 1) / 2;
  panel.fill(box.x, box.y, box.width, upper, get_middle_shade(player.shirt));
  panel.fill(box.x, box.y + upper, box.width, box.height - upper, get_middle_shade(player.pants));
  panel.draw_text(align_right(player.frags, kFragDigits),
                  box.x + (box.width - kFragDigits * kCharacterSide) / 2,
                  box.y + box.height - kCharacterSide);
}

constexpr int kUpperY = 4, kLowerY = 12, kLeftX = 8;  // rows and left edge of the score bar

// Draws "Monsters:  3 / 21".
void draw_tally(const Panel& bar, std::string_view label, int part, int whole, int y) {
  constexpr int kCountDigits = 3;
  fmt::memory_buffer line;  // an inline buffer, as a string of that length would allocate
  fmt::format_to(std::back_inserter(line), "{}:{} /{}", label, align_right(part, kCountDigits),
                 align_right(whole, kCountDigits));
  bar.draw_text({line.data(), line.size()}, kLeftX, y);
}

// Draws the player's frags and rank in a deathmatch.
void draw_standing(const Panel& bar, const Game& game) {
  const std::size_t viewer = game.view_entity - std::size_t{1};
  if (viewer >= game.players.size()) return;
  const int frags = game.players[viewer].frags;
  int players = 0, place = 1;
  for (const Player& player : game.players) {
    if (player.name.empty()) continue;
    ++players;
    place += player.frags > frags ? 1 : 0;
  }
  bar.draw_text("Frags:", kLeftX, kUpperY);
  bar.draw_text(align_right(frags, kFragDigits), kLeftX + 6 * kCharacterSide, kUpperY);
  draw_tally(bar, "Place", place, players, kLowerY);
}

constexpr std::size_t kTeams = 16;
// By color; none: there is no such team.
using TeamScores = std::array<std::optional<std::int16_t>, kTeams>;

TeamScores sum_frags(const Game& game) {
  TeamScores sums;
  for (const Player& player : game.players)
    if (std::optional<std::int16_t>& sum = sums[player.pants & 15u]; !player.name.empty())
      sum = static_cast<std::int16_t>(sum.value_or(0) + player.frags);
  return sums;
}

// Draws text centered, shortened with "..." to at most that many characters.
void draw_shortened(const Panel& bar, std::string_view text, std::size_t max_chars, int middle_x, int y) {
  constexpr std::string_view kMissing = "...";
  const bool fits = text.size() <= max_chars;
  if (!fits) text = text.substr(0, max_chars - kMissing.size());
  while (!fits && text.ends_with(' ')) text.remove_suffix(1);
  const std::size_t chars = text.size() + (fits ? 0 : kMissing.size());
  const int x = middle_x - static_cast<int>(chars) * kCharacterSide / 2;
  bar.draw_text(text, x, y);
  if (!fits) bar.draw_text(kMissing, x + static_cast<int>(text.size()) * kCharacterSide, y);
}

}  // namespace

void draw_level_scores(const Panel& bar, const Game& game, double time_s, float opacity) {
  constexpr int kTimeX = 184, kNameMiddleX = 232;
  constexpr std::size_t kMaxNameChars = 20;  // the room right of the counts
  bar.draw_picture("scorebar", 0, 0, opacity);
  if (game.deathmatch) {
    draw_standing(bar, game);
  } else {
    draw_tally(bar, "Monsters", game.stat(Stat::kMonsters), game.stat(Stat::kTotalMonsters), kUpperY);
    draw_tally(bar, "Secrets ", game.stat(Stat::kSecrets), game.stat(Stat::kTotalSecrets), kLowerY);
  }
  const int seconds = static_cast<int>(std::clamp(time_s, 0.0, 59999.0));
  bar.draw_text(fmt::format("Time :{:3}:{:02}", seconds / 60, seconds % 60), kTimeX, kUpperY);
  draw_shortened(bar, game.level_name, kMaxNameChars, kNameMiddleX, kLowerY);
}

void draw_leaders(const Panel& inventory, const Game& game) {
  constexpr std::size_t kShown = 4;
  // Four boxes fit in the inventory's top row, above keys and power-ups.
  constexpr int kFirstX = 194, kApart = 32, kWidth = 28, kHeight = 7;
  const Ranking ranking(game);
  int x = kFirstX;
  for (const std::size_t player : ranking.players().first(std::min(ranking.players().size(), kShown))) {
    draw_frags(inventory, game.players[player], {x, 1, kWidth, kHeight});
    if (is_viewer(game, player)) {
      inventory.draw_character(kOpeningBracket, x - 4, 0);
      inventory.draw_character(kClosingBracket, x + kWidth - 4, 0);
    }
    x += kApart;
  }
}

// Places and digits are those that QuakeSpasm 0.95 showed. White digits would be invisible on a white shirt.
void draw_team_frame(const Panel& bar, const Game& game) {
  constexpr int kX = 112, kInnerX = 113, kInnerY = 3, kWidth = 22, kHalf = 9, kSmallDigitWidth = 7;
  constexpr std::uint8_t kSmallZero = 18;
  bar.draw_picture(kTeamFramePicture, kX, 0);
  const std::size_t viewer = game.view_entity - std::size_t{1};
  if (viewer >= game.players.size()) return;
  const Player& player = game.players[viewer];
  bar.fill(kInnerX, kInnerY, kWidth, kHalf, get_middle_shade(player.shirt));
  bar.fill(kInnerX, kInnerY + kHalf, kWidth, kHalf, get_middle_shade(player.pants));
  const std::string frags = align_right(player.frags, kFragDigits);
  for (std::size_t i = 0; i < frags.size(); ++i) {
    const char digit = frags[i];
    const bool needs_small = player.shirt == 0 && digit >= '0' && digit <= '9';
    if (digit != ' ')
      bar.draw_character(static_cast<std::uint8_t>(needs_small ? kSmallZero + digit - '0' : digit),
                         kInnerX + static_cast<int>(i) * kSmallDigitWidth, kInnerY);
  }
}

bool has_captures(const Game& game) {
  return std::any_of(game.captures.begin(), game.captures.end(),
                     [](const auto& count) { return count.has_value(); });
}

void draw_team_scores(const Panel& screen, const Game& game) {
  constexpr std::size_t kShown = 6;
  constexpr std::string_view kCaptures = "Captures";
  constexpr int kY = 32, kWidth = 40, kApart = 48;
  const bool captures = has_captures(game);
  const TeamScores scores = captures ? game.captures : sum_frags(game);
  std::array<Player, kTeams> teams;  // as a player in the team's color
  std::size_t count = 0;
  for (std::uint8_t color = 0; color < kTeams; ++color) {
    if (!scores[color]) continue;
    Player& team = teams[count++];
    team.frags = *scores[color];
    team.shirt = team.pants = color;
  }
  if (count < 2) return;
  std::sort(teams.begin(), teams.begin() + count, [](const Player& a, const Player& b) {
    return a.frags != b.frags ? a.frags > b.frags : a.pants < b.pants;
  });
  count = std::min(count, kShown);
  const int label_width = captures ? static_cast<int>(kCaptures.size() + 1) * kCharacterSide : 0;
  int x = (kScreenWidth - label_width - (static_cast<int>(count) - 1) * kApart - kWidth) / 2;
  if (captures) screen.draw_text(kCaptures, x, kY);
  x += label_width;
  for (const Player& team : std::span(teams).first(count)) {
    draw_frags(screen, team, {x, kY, kWidth, kCharacterSide});
    x += kApart;
  }
}

void draw_ranking(const Panel& screen, const Game& game) {
  // Players beyond the bottom of the screen are not shown.
  constexpr int kTitleY = 8, kFirstY = 40, kApart = 10;
  constexpr int kFragsX = 80, kFragsWidth = 40, kArrowX = 128, kNameX = 144;
  screen.draw_centered_picture("gfx/ranking.lmp", kTitleY);
  int y = kFirstY;
  const Ranking ranking(game);
  for (const std::size_t player : ranking.players()) {
    if (y + kCharacterSide > kScreenHeight) return;
    draw_frags(screen, game.players[player], {kFragsX, y, kFragsWidth, kCharacterSide});
    if (is_viewer(game, player)) screen.draw_character(kArrow, kArrowX, y);
    screen.draw_text(game.players[player].name, kNameX, y);
    y += kApart;
  }
}

}  // namespace temblor::client
