// Resonances of vowels: means of men in G. Peterson and H. Barney, "Control methods used in a study of the
// vowels", 1952; the fourth and fifth, which hardly move, and loudnesses are round numbers.
#include "artgen/sounds/synthesis/vowels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr std::size_t kFormants = 5;
struct Vowel {
  char letter;
  std::array<double, kFormants> hertz, loudness;
};
constexpr std::array<Vowel, 7> kVowels = {{
    {'a', {730, 1090, 2440, 3400, 4200}, {1, 0.7, 0.35, 0.2, 0.1}},
    {'e', {530, 1840, 2480, 3500, 4200}, {1, 0.5, 0.4, 0.2, 0.1}},
    {'i', {270, 2290, 3010, 3600, 4300}, {1, 0.4, 0.35, 0.2, 0.1}},
    {'o', {570, 840, 2410, 3300, 4100}, {1, 0.6, 0.15, 0.1, 0.05}},
    {'u', {300, 870, 2240, 3200, 4000}, {1, 0.4, 0.1, 0.05, 0.03}},
    {'r', {490, 1350, 1690, 3200, 4000}, {1, 0.6, 0.5, 0.1, 0.05}},
    {'m', {250, 950, 2100, 3100, 4000}, {0.7, 0.08, 0.04, 0.02, 0.01}},
}};
constexpr std::array<double, kFormants> kWidths = {80, 100, 140, 200, 260};

struct Places {
  std::vector<std::size_t> vowels;
  std::vector<Curve::Point> points;
};

Places read_places(Arguments& io_arguments, std::string_view text, double length_s) {
  Places places;
  for (const TimedWord& word : timed_words(text, length_s)) {
    const auto vowel = std::find_if(kVowels.begin(), kVowels.end(), [&](const Vowel& known) {
      return word.word.size() == 1 && known.letter == word.word.front();
    });
    if (vowel == kVowels.end()) {
      places = {};
      break;
    }
    places.points.push_back({word.time_s, static_cast<double>(places.vowels.size())});
    places.vowels.push_back(static_cast<std::size_t>(vowel - kVowels.begin()));
  }
  if (!places.vowels.empty()) return places;
  io_arguments.complain(
      fmt::format("'{}' are no vowels; as o..a@0.1..u, of a e i o u r m", base::quotable(text)));
  return {{0}, {{0, 0}}};
}

}  // namespace

Mouth::Mouth(Arguments& io_arguments, std::string_view vowels, double size, double length_s)
    : place_({{0, 0}}, Glide::kSteady), size_(size) {
  Places places = read_places(io_arguments, vowels, length_s);
  place_ = Curve(std::move(places.points), Glide::kSteady);
  vowels_ = std::move(places.vowels);
}

void Mouth::apply(Signal& io_signal, double rate) const {
  constexpr std::size_t kStep = 64;
  std::array<StateFilter, kFormants> filters;
  std::array<double, kFormants> loudness{};
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    if (i % kStep == 0) {
      const double place = place_.at(static_cast<double>(i) / rate);
      const auto before = static_cast<std::size_t>(place);
      const Vowel& from = kVowels[vowels_[before]];
      const Vowel& to = kVowels[vowels_[std::min(before + 1, vowels_.size() - 1)]];
      const double part = place - std::floor(place);
      for (std::size_t k = 0; k < kFormants; ++k) {
        const double hertz = (from.hertz[k] + (to.hertz[k] - from.hertz[k]) * part) / size_;
        filters[k].set(hertz, hertz / (kWidths[k] / std::sqrt(size_)), rate);
        loudness[k] = from.loudness[k] + (to.loudness[k] - from.loudness[k]) * part;
      }
    }
    double sum = 0;
    // Neighbors with opposite signs: between two resonances they then add up, as in a throat.
    for (std::size_t k = 0; k < kFormants; ++k)
      sum += (k % 2 == 0 ? 1 : -1) * loudness[k] * filters[k].step(io_signal[i]).band;
    io_signal[i] = sum;
  }
}

}  // namespace temblor::artgen
