#include "formats/nearest_colour.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr int kCellShift = 4;
constexpr int kCellsPerChannel = 256 >> kCellShift;

// The least and greatest squared distance of a channel's value to those of a cell.
struct Reach {
  int least, greatest;
};

Reach reach_of(int value, int cell) {
  const int low = value - (cell << kCellShift);
  const int high = ((cell + 1) << kCellShift) - 1 - value;
  const int farthest = std::max(std::abs(low), std::abs(high));
  const int outside = std::max({0, -low, -high});
  return {outside * outside, farthest * farthest};
}

Reach reach_of(Rgb colour, int r, int g, int b) {
  const Reach red = reach_of(colour.r, r), green = reach_of(colour.g, g), blue = reach_of(colour.b, b);
  return {red.least + green.least + blue.least, red.greatest + green.greatest + blue.greatest};
}

int squared_distance(Rgb a, Rgb b) {
  const int dr = a.r - b.r, dg = a.g - b.g, db = a.b - b.b;
  return dr * dr + dg * dg + db * db;
}

}  // namespace

NearestColour::NearestColour(const Palette& palette, std::size_t first, std::size_t count)
    : palette_(palette) {
  CHECK(count > 0 && first + count <= palette.size(), "{} from {}", count, first);
  std::array<Reach, 256> reaches{};
  for (int r = 0; r < kCellsPerChannel; ++r)
    for (int g = 0; g < kCellsPerChannel; ++g)
      for (int b = 0; b < kCellsPerChannel; ++b) {
        first_candidates_.push_back(static_cast<std::uint32_t>(candidates_.size()));
        int bound = std::numeric_limits<int>::max();
        for (std::size_t i = first; i < first + count; ++i) {
          reaches[i] = reach_of(palette[i], r, g, b);
          bound = std::min(bound, reaches[i].greatest);
        }
        for (std::size_t i = first; i < first + count; ++i)
          if (reaches[i].least <= bound) candidates_.push_back(static_cast<std::uint8_t>(i));
      }
  first_candidates_.push_back(static_cast<std::uint32_t>(candidates_.size()));
}

std::span<const std::uint8_t> NearestColour::candidates_near(Rgb colour) const {
  const auto cell = static_cast<std::size_t>(
      ((colour.r >> kCellShift) * kCellsPerChannel + (colour.g >> kCellShift)) * kCellsPerChannel +
      (colour.b >> kCellShift));
  return std::span(candidates_)
      .subspan(first_candidates_[cell], first_candidates_[cell + 1] - first_candidates_[cell]);
}

std::uint8_t NearestColour::find(Rgb colour) const {
  std::uint8_t best = 0;
  int best_distance = std::numeric_limits<int>::max();
  for (const std::uint8_t index : candidates_near(colour)) {
    const int distance = squared_distance(palette_[index], colour);
    if (distance < best_distance) {
      best = index;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace temblor::formats
