#include "formats/images/nearest_color.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr int kFineSize = 16;
constexpr int kFineCells = 256 / kFineSize;  // cells of each channel
// The cube is divided into 4 x 4 x 4 cells, each of these into 2 x 2 x 2, and these once more: the candidates
// of a small cell are a subset of those of the large cell around it, so only few need testing.
constexpr int kLevels = 3, kMaxParts = 4;
constexpr int kParts[kLevels] = {4, 2, 2};

constexpr std::size_t cell_index(int r, int g, int b) {
  return static_cast<std::size_t>((r / kFineSize * kFineCells + g / kFineSize) * kFineCells + b / kFineSize);
}

constexpr int squared(int x) {
  return x * x;
}

// Squared distances in one channel from a value to the nearest value of a cell, in the low half, and to the
// farthest one, in the high half: so one addition sums both.
using Reach = std::uint64_t;
constexpr Reach kNearest = 0xffffffffu;
constexpr int kFarthestShift = 32;

Reach reach(int value, int low, int size) {
  const int below = low - value, above = value - (low + size - 1);
  const auto nearest = static_cast<Reach>(squared(std::max({below, above, 0})));
  return nearest | static_cast<Reach>(squared(std::min(below, above))) << kFarthestShift;
}

using Reaches = std::array<Reach, std::tuple_size_v<Palette>>;  // of each candidate

}  // namespace

NearestColor::NearestColor(const Palette& palette, std::size_t first, std::size_t count)
    : cells_(std::size_t{kFineCells} * kFineCells * kFineCells) {
  CHECK(count > 0 && first + count <= palette.size(), "{} from {}", count, first);
  std::vector<Candidate> all;
  for (std::size_t i = first; i < first + count; ++i)
    all.push_back({palette[i].r, palette[i].g, palette[i].b, static_cast<std::uint8_t>(i)});
  divide({0, 0, 0, 256}, all, 0);
}

void NearestColor::divide(const Cell& cell, std::span<const Candidate> among, std::size_t level) {
  const int parts = kParts[level], size = cell.size / parts;
  Reaches by_r[kMaxParts], by_g[kMaxParts], by_b[kMaxParts];
  for (int part = 0; part < parts; ++part) {
    const int offset = part * size;
    for (std::size_t i = 0; i < among.size(); ++i) {
      by_r[part][i] = reach(among[i].r, cell.r + offset, size);
      by_g[part][i] = reach(among[i].g, cell.g + offset, size);
      by_b[part][i] = reach(among[i].b, cell.b + offset, size);
    }
  }
  std::array<Candidate, std::tuple_size_v<Palette>> found;
  Reaches sums;
  for (int r = 0; r < parts; ++r)
    for (int g = 0; g < parts; ++g)
      for (int b = 0; b < parts; ++b) {
        // A color whose nearest distance exceeds the smallest farthest distance of any color is never the
        // nearest.
        std::uint64_t smallest = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t i = 0; i < among.size(); ++i) {
          sums[i] = by_r[r][i] + by_g[g][i] + by_b[b][i];
          smallest = std::min(smallest, sums[i]);
        }
        const std::uint64_t bound = smallest >> kFarthestShift;
        std::size_t found_count = 0;
        for (std::size_t i = 0; i < among.size(); ++i) {
          found[found_count] = among[i];
          found_count += (sums[i] & kNearest) <= bound ? 1 : 0;
        }
        const std::span<const Candidate> of_part(found.data(), found_count);
        const Cell part{cell.r + r * size, cell.g + g * size, cell.b + b * size, size};
        if (size > kFineSize) {
          divide(part, of_part, level + 1);
          continue;
        }
        const auto begin = static_cast<std::uint32_t>(candidates_.size());
        candidates_.insert(candidates_.end(), of_part.begin(), of_part.end());
        cells_[cell_index(part.r, part.g, part.b)] = {begin, static_cast<std::uint32_t>(candidates_.size())};
      }
}

std::uint8_t NearestColor::find(Rgb color) const {
  const Range cell = cells_[cell_index(color.r, color.g, color.b)];
  int best_distance = std::numeric_limits<int>::max();
  std::uint8_t found = 0;
  for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
    const Candidate& candidate = candidates_[i];
    const int distance =
        squared(candidate.r - color.r) + squared(candidate.g - color.g) + squared(candidate.b - color.b);
    if (distance >= best_distance) continue;
    best_distance = distance;
    found = candidate.index;
  }
  return found;
}

}  // namespace temblor::formats
