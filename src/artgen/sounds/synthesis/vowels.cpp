// The first three formants of each vowel are the averages of male speakers in G. Peterson and H. Barney,
// "Control Methods Used in a Study of the Vowels", 1952. The fourth and fifth, which hardly move, and the
// loudnesses are round numbers.
#include "artgen/sounds/synthesis/vowels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr std::size_t kFormants = 5;
// Frequencies and relative amplitudes of the formants.
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
// The same for all vowels.
constexpr std::array<double, kFormants> kBandwidths_hz = {80, 100, 140, 200, 260};

// Rows of kVowels, and the curve of the index among them.
struct VowelSequence {
  std::vector<std::size_t> vowels;
  std::vector<Curve::Point> points;
};

// After an error, returns the first vowel of the table.
VowelSequence read_vowel_sequence(Arguments& io_arguments, std::string_view text, double length_s) {
  VowelSequence places;
  for (const TimedText& part : parse_timed_texts(text, length_s)) {
    const auto vowel = std::find_if(kVowels.begin(), kVowels.end(), [&](const Vowel& known) {
      return part.text.size() == 1 && known.letter == part.text.front();
    });
    if (vowel == kVowels.end()) {
      places = {};
      break;
    }
    places.points.push_back({part.time_s, static_cast<double>(places.vowels.size())});
    places.vowels.push_back(static_cast<std::size_t>(vowel - kVowels.begin()));
  }
  if (!places.vowels.empty()) return places;
  io_arguments.set_error(
      fmt::format("'{}' is not a vowel sequence such as o..a@0.1..u; the vowels are a e i o u r m",
                  base::quotable(text)));
  return {{0}, {{0, 0}}};
}

}  // namespace

VowelFilter::VowelFilter(Arguments& io_arguments, std::string_view vowels, double size, double length_s)
    : position_({{0, 0}}, Glide::kLinear), size_(size) {
  VowelSequence places = read_vowel_sequence(io_arguments, vowels, length_s);
  position_ = Curve(std::move(places.points), Glide::kLinear);
  vowels_ = std::move(places.vowels);
}

void VowelFilter::apply(Signal& io_signal, double rate) const {
  // The filters' coefficients change every 64 samples.
  constexpr std::size_t kStep = 64;
  std::array<StateVariableFilter, kFormants> filters;
  std::array<double, kFormants> loudness{};
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    if (i % kStep == 0) {
      const double place = position_.at(static_cast<double>(i) / rate);
      const auto before = static_cast<std::size_t>(place);
      const Vowel& from = kVowels[vowels_[before]];
      const Vowel& to = kVowels[vowels_[std::min(before + 1, vowels_.size() - 1)]];
      const double part = place - std::floor(place);
      for (std::size_t k = 0; k < kFormants; ++k) {
        const double hertz = (from.hertz[k] + (to.hertz[k] - from.hertz[k]) * part) / size_;
        filters[k].set(hertz, hertz / (kBandwidths_hz[k] / std::sqrt(size_)), rate);
        loudness[k] = from.loudness[k] + (to.loudness[k] - from.loudness[k]) * part;
      }
    }
    double sum = 0;
    // The formants are filtered in parallel. Neighbors have opposite signs: between two resonances their
    // phases then agree, and the sum has no notch there, as in a vocal tract.
    for (std::size_t k = 0; k < kFormants; ++k)
      sum += (k % 2 == 0 ? 1 : -1) * loudness[k] * filters[k].step(io_signal[i]).band;
    io_signal[i] = sum;
  }
}

}  // namespace temblor::artgen
