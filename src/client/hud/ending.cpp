#include "client/hud/ending.h"

#include <algorithm>

#include "client/hud/center_text.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

// Positions next to the words of gfx/inter.lmp, in the original's pixels.
constexpr int kNumbersX = 160, kTimeY = 64, kSecretsY = 104, kKillsY = 144;
constexpr int kNumberDigits = 3, kDigitWidth = 24;

// Draws minutes and seconds with a large colon: "  3:05".
void draw_time(const Panel& screen, double time_s) {
  constexpr int kColonX = kNumbersX + kNumberDigits * kDigitWidth, kSecondsX = kColonX + 16;
  const int seconds = static_cast<int>(std::clamp(time_s, 0.0, 59999.0));
  screen.draw_number(seconds / 60, kNumberDigits, false, kNumbersX, kTimeY);
  screen.draw_picture("num_colon", kColonX, kTimeY);
  screen.draw_number(seconds % 60 / 10, 1, false, kSecondsX, kTimeY);
  screen.draw_number(seconds % 10, 1, false, kSecondsX + kDigitWidth, kTimeY);
}

// Draws "  7/ 12" in large digits: found and total.
void draw_fraction(const Panel& screen, int part, int whole, int y) {
  constexpr int kSlashX = kNumbersX + kNumberDigits * kDigitWidth, kWholeX = kSlashX + 16;
  screen.draw_number(part, kNumberDigits, false, kNumbersX, y);
  screen.draw_picture("num_slash", kSlashX, y);
  screen.draw_number(whole, kNumberDigits, false, kWholeX, y);
}

}  // namespace

void draw_intermission(const Panel& panel, const Game& game) {
  const Panel screen = panel.in_middle(kScreenHeight);
  if (game.deathmatch) {
    draw_ranking(screen, game);
    return;
  }
  constexpr int kTitleY = 24, kWordsX = 0, kWordsY = 56;
  screen.draw_centered_picture("gfx/complete.lmp", kTitleY);
  screen.draw_picture("gfx/inter.lmp", kWordsX, kWordsY);
  draw_time(screen, game.ending_since_s);
  draw_fraction(screen, game.stat(Stat::kSecrets), game.stat(Stat::kTotalSecrets), kSecretsY);
  draw_fraction(screen, game.stat(Stat::kMonsters), game.stat(Stat::kTotalMonsters), kKillsY);
}

void draw_finale(const Panel& panel, const Panel& letters, const Game& game, double time_s,
                 double letters_per_second) {
  constexpr int kTitleY = 16;
  if (game.ending == Ending::kFinale)
    panel.in_middle(kScreenHeight).draw_centered_picture("gfx/finale.lmp", kTitleY);
  draw_center_text(letters, game.ending_text,
                   count_written_letters(time_s - game.ending_since_s, letters_per_second));
}

}  // namespace temblor::client
