#include "render/colour/nearest_colour.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "base/check.h"

namespace temblor::render {

namespace {

constexpr int squared(int x) {
  return x * x;
}

// Squared distances, in one channel, from a colour's value to the nearest and the farthest one of a cell.
struct Reach {
  int nearest, farthest;
};
Reach reach(int value, int first, int last) {
  return {squared(std::max({first - value, value - last, 0})),
          squared(std::max(std::abs(value - first), std::abs(value - last)))};
}

}  // namespace

NearestColour::NearestColour(const formats::Palette& palette, std::span<const std::uint8_t> eligible) {
  CHECK(!eligible.empty());
  // By channel, cell and entry.
  std::vector<Reach> reaches(std::size_t{3} * kCells * eligible.size());
  const auto reaches_of = [&](std::size_t channel, int cell) {
    return std::span(reaches).subspan((channel * kCells + static_cast<std::size_t>(cell)) * eligible.size(),
                                      eligible.size());
  };
  for (int cell = 0; cell < kCells; ++cell)
    for (std::size_t i = 0; i < eligible.size(); ++i) {
      const formats::Rgb colour = palette[eligible[i]];
      const int first = cell * kCellSize, last = first + kCellSize - 1;
      reaches_of(0, cell)[i] = reach(colour.r, first, last);
      reaches_of(1, cell)[i] = reach(colour.g, first, last);
      reaches_of(2, cell)[i] = reach(colour.b, first, last);
    }
  std::size_t cell = 0;
  for (int r = 0; r < kCells; ++r)
    for (int g = 0; g < kCells; ++g)
      for (int b = 0; b < kCells; ++b) {
        const auto in_r = reaches_of(0, r), in_g = reaches_of(1, g), in_b = reaches_of(2, b);
        // No entry that is nowhere nearer than this can be the nearest.
        int bound = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < eligible.size(); ++i)
          bound = std::min(bound, in_r[i].farthest + in_g[i].farthest + in_b[i].farthest);
        for (std::size_t i = 0; i < eligible.size(); ++i) {
          if (in_r[i].nearest + in_g[i].nearest + in_b[i].nearest > bound) continue;
          const formats::Rgb colour = palette[eligible[i]];
          candidates_.push_back({colour.r, colour.g, colour.b, eligible[i]});
        }
        begin_[++cell] = static_cast<std::uint32_t>(candidates_.size());
      }
}

std::uint8_t NearestColour::operator()(formats::Rgb colour) const {
  const std::size_t cell =
      (std::size_t{colour.r} / kCellSize * kCells + colour.g / kCellSize) * kCells + colour.b / kCellSize;
  int least = std::numeric_limits<int>::max();
  std::uint8_t found = 0;
  for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
    const Candidate& candidate = candidates_[i];
    const int distance =
        squared(candidate.r - colour.r) + squared(candidate.g - colour.g) + squared(candidate.b - colour.b);
    if (distance >= least) continue;
    least = distance;
    found = candidate.index;
  }
  return found;
}

}  // namespace temblor::render
