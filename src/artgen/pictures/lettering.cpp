// A letter is a list of cuts between points of a grid that is 6 high and 4 wide (6 for M and W). "06 00 40"
// goes from the lower left corner up and then to the right: each pair of digits is x and y. A bar starts a
// new cut.
#include "artgen/pictures/lettering.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/check.h"

namespace temblor::artgen::pictures {
namespace {

constexpr double kGridHeight = 6, kBlankWidth = 2;

struct Letter {
  char name;
  std::string_view cuts;
};

constexpr std::array kLetters = {
    Letter{'A', "06 02 20 42 46|04 44"},
    Letter{'B', "00 06 36 45 44 33 03|03 33 42 41 30 00"},
    Letter{'C', "41 30 10 01 05 16 36 45"},
    Letter{'D', "00 06 26 44 42 20 00"},
    Letter{'E', "40 00 06 46|03 33"},
    Letter{'F', "40 00 06|03 33"},
    Letter{'G', "41 30 10 01 05 16 36 45 43 33"},
    Letter{'H', "00 06|40 46|03 43"},
    Letter{'I', "00 06"},
    Letter{'J', "30 35 26 16 05"},
    Letter{'K', "00 06|40 03 46"},
    Letter{'L', "00 06 46"},
    Letter{'M', "06 00 33 60 66"},
    Letter{'N', "06 00 46 40"},
    Letter{'O', "10 30 41 45 36 16 05 01 10"},
    Letter{'P', "06 00 30 41 42 33 03"},
    Letter{'Q', "10 30 41 45 36 16 05 01 10|24 46"},
    Letter{'R', "06 00 30 41 42 33 03|23 46"},
    Letter{'S', "41 30 10 01 02 13 33 44 45 36 16 05"},
    Letter{'T', "00 40|20 26"},
    Letter{'U', "00 05 16 36 45 40"},
    Letter{'V', "00 26 40"},
    Letter{'W', "00 16 32 56 60"},
    Letter{'X', "00 46|40 06"},
    Letter{'Y', "00 23 40|23 26"},
    Letter{'Z', "00 40 06 46"},
    Letter{'0', "10 30 41 45 36 16 05 01 10"},
    Letter{'1', "11 20 26|16 36"},
    Letter{'2', "01 10 30 41 42 06 46"},
    Letter{'3', "01 10 30 41 42 33 44 45 36 16 05|13 33"},
    Letter{'4', "36 30 04 44"},
    Letter{'5', "40 00 03 33 44 45 36 16 05"},
    Letter{'6', "41 30 10 01 05 16 36 45 44 33 03"},
    Letter{'7', "00 40 42 16"},
    Letter{'8', "10 30 41 42 33 13 02 01 10|13 04 05 16 36 45 44 33"},
    Letter{'9', "43 13 02 01 10 30 41 45 36 16 05"},
    Letter{'-', "03 33"},
    Letter{':', "02|05"},
    Letter{'/', "06 30"},
    Letter{'.', "06"},
    Letter{'!', "00 03|06"},
    Letter{'\'', "00 01"},
};

char to_capital(char letter) {
  return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
}

const Letter* find_letter(char name) {
  const auto found = std::find_if(kLetters.begin(), kLetters.end(),
                                  [&](const Letter& letter) { return letter.name == to_capital(name); });
  return found != kLetters.end() ? &*found : nullptr;
}

// The largest x of a letter's cuts. Every entry has three characters: x, y, and a separator.
double grid_width(const Letter& letter) {
  char widest = '0';
  for (std::size_t i = 0; i < letter.cuts.size(); i += 3) widest = std::max(widest, letter.cuts[i]);
  return widest - '0';
}

// The distance in pixels between two grid lines.
math::Vec2d grid_step(const LetteringStyle& style) {
  const double down = (style.height - style.weight) / kGridHeight;
  return {down * style.narrow, down};
}

// From a letter's left edge to the next letter's.
double measure_advance(char name, const LetteringStyle& style) {
  const Letter* const letter = find_letter(name);
  const double step = grid_step(style).x;
  return letter == nullptr ? kBlankWidth * step : grid_width(*letter) * step + style.weight + style.spacing;
}

}  // namespace

bool has_letter(char letter) {
  return letter == ' ' || find_letter(letter) != nullptr;
}

double measure_text(std::string_view text, const LetteringStyle& style) {
  double width = -style.spacing;
  for (const char name : text) width += measure_advance(name, style);
  return std::max(width, 0.0);
}

Outline make_text(std::string_view text, math::Vec2d left_top, const LetteringStyle& style) {
  std::vector<Outline> cuts;
  math::Vec2d corner = left_top + math::Vec2d{style.weight, style.weight} * 0.5;
  for (const char name : text) {
    CHECK(has_letter(name), "{}", name);
    if (const Letter* const letter = find_letter(name)) {
      std::vector<math::Vec2d> points;
      for (std::size_t i = 0; i < letter->cuts.size(); i += 3) {
        points.push_back(corner +
                         math::Vec2d{letter->cuts[i] - '0', letter->cuts[i + 1] - '0'} * grid_step(style));
        if (i + 2 < letter->cuts.size() && letter->cuts[i + 2] == ' ') continue;
        cuts.push_back(make_line(points, style.weight, style.flare));
        points.clear();
      }
    }
    corner.x += measure_advance(name, style);
  }
  CHECK(!cuts.empty(), "no letter to see");
  return join_outlines(std::move(cuts));
}

}  // namespace temblor::artgen::pictures
