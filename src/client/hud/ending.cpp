#include "client/hud/ending.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "client/hud/center_text.h"
#include "client/hud/scoreboard.h"

namespace temblor::client {

namespace {

// Positions next to the words of gfx/inter.lmp, in the original's pixels.
constexpr int kNumbersX = 160, kTimeY = 64, kParY = 91, kSecretsY = 104, kKillsY = 144;
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

// Draws "par 4:30", right-aligned below the time.
void draw_par(const Panel& screen, int par_s, bool is_reached) {
  constexpr int kRight = kNumbersX + (kNumberDigits + 2) * kDigitWidth + 16;
  std::array<char, 16> text{};
  const auto end = fmt::format_to_n(text.data(), text.size(), "par {}:{:02}", par_s / 60, par_s % 60).out;
  const std::span letters(text.data(), end);
  if (is_reached)
    for (char& letter : letters) letter = static_cast<char>(letter | 0x80);
  screen.draw_text({letters.data(), letters.size()},
                   kRight - static_cast<int>(letters.size()) * kCharacterSide, kParY);
}

// Draws "  7/ 12" in large digits: found and total.
void draw_fraction(const Panel& screen, int part, int whole, int y) {
  constexpr int kSlashX = kNumbersX + kNumberDigits * kDigitWidth, kWholeX = kSlashX + 16;
  screen.draw_number(part, kNumberDigits, false, kNumbersX, y);
  screen.draw_picture("num_slash", kSlashX, y);
  screen.draw_number(whole, kNumberDigits, false, kWholeX, y);
}

}  // namespace

void draw_intermission(const Panel& panel, const Game& game, float par_s) {
  const Panel screen = panel.in_middle(kScreenHeight);
  if (game.deathmatch) {
    draw_ranking(screen, game);
    return;
  }
  constexpr int kTitleY = 24, kWordsX = 0, kWordsY = 56;
  screen.draw_centered_picture("gfx/complete.lmp", kTitleY);
  screen.draw_picture("gfx/inter.lmp", kWordsX, kWordsY);
  draw_time(screen, game.ending_since_s);
  if (par_s > 0) draw_par(screen, static_cast<int>(par_s), game.ending_since_s < par_s + 1);
  draw_fraction(screen, game.stat(Stat::kSecrets), game.stat(Stat::kTotalSecrets), kSecretsY);
  draw_fraction(screen, game.stat(Stat::kMonsters), game.stat(Stat::kTotalMonsters), kKillsY);
}

void draw_finale(const Panel& panel, const Panel& letters, const Game& game, double time_s,
                 double letters_per_second) {
  constexpr int kTitleY = 16, kTitleBottom = 44;  // with a gap below it
  int min_top_px = 0;
  if (game.ending == Ending::kFinale) {
    panel.in_middle(kScreenHeight).draw_centered_picture("gfx/finale.lmp", kTitleY);
    min_top_px = (panel.frame_height_px() - kScreenHeight * panel.scale()) / 2 + kTitleBottom * panel.scale();
  }
  draw_center_text(letters, game.ending_text,
                   count_written_letters(time_s - game.ending_since_s, letters_per_second), min_top_px);
}

}  // namespace temblor::client
