#include "formats/images/nearest_color.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr int kCoarseSize = 64, kMiddleSize = 32, kFineSize = 16;
constexpr int kFineCells = 256 / kFineSize;  // cells of each channel

constexpr std::size_t cell_index(int r, int g, int b) {
  return static_cast<std::size_t>((r / kFineSize * kFineCells + g / kFineSize) * kFineCells + b / kFineSize);
}

constexpr int squared(int x) {
  return x * x;
}

// Squared distances in one channel from a value to the nearest and the farthest value of a cell.
struct Reach {
  int nearest, farthest;
};
Reach reach(int value, int low, int size) {
  const int below = low - value, above = value - (low + size - 1);
  return {squared(std::max({below, above, 0})), squared(std::min(below, above))};
}

// Calls `visit` with the lowest corner of every cell of a cube.
template <typename Visit>
void for_each_cell(int low_r, int low_g, int low_b, int cube_size, int cell_size, Visit visit) {
  for (int r = low_r; r < low_r + cube_size; r += cell_size)
    for (int g = low_g; g < low_g + cube_size; g += cell_size)
      for (int b = low_b; b < low_b + cube_size; b += cell_size) visit(r, g, b);
}

}  // namespace

NearestColor::NearestColor(const Palette& palette, std::size_t first, std::size_t count)
    : cells_(std::size_t{kFineCells} * kFineCells * kFineCells) {
  CHECK(count > 0 && first + count <= palette.size(), "{} from {}", count, first);
  std::vector<Candidate> all, coarse, middle;
  for (std::size_t i = first; i < first + count; ++i)
    all.push_back({palette[i].r, palette[i].g, palette[i].b, static_cast<std::uint8_t>(i)});
  // The candidates of a small cell are a subset of those of the large cell around it, so only few need
  // testing.
  for_each_cell(0, 0, 0, 256, kCoarseSize, [&](int coarse_r, int coarse_g, int coarse_b) {
    coarse.clear();
    add_candidates({coarse_r, coarse_g, coarse_b, kCoarseSize}, all, coarse);
    for_each_cell(
        coarse_r, coarse_g, coarse_b, kCoarseSize, kMiddleSize,
        [&](int middle_r, int middle_g, int middle_b) {
          middle.clear();
          add_candidates({middle_r, middle_g, middle_b, kMiddleSize}, coarse, middle);
          for_each_cell(middle_r, middle_g, middle_b, kMiddleSize, kFineSize, [&](int r, int g, int b) {
            const auto begin = static_cast<std::uint32_t>(candidates_.size());
            add_candidates({r, g, b, kFineSize}, middle, candidates_);
            cells_[cell_index(r, g, b)] = {begin, static_cast<std::uint32_t>(candidates_.size())};
          });
        });
  });
}

void NearestColor::add_candidates(const Cell& cell, std::span<const Candidate> among,
                                  std::vector<Candidate>& io_found) {
  // A color whose nearest distance exceeds the smallest farthest distance of any color is never the nearest.
  std::array<int, std::tuple_size_v<Palette>> nearest;
  int bound = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < among.size(); ++i) {
    const Candidate& color = among[i];
    const Reach r = reach(color.r, cell.r, cell.size), g = reach(color.g, cell.g, cell.size),
                b = reach(color.b, cell.b, cell.size);
    nearest[i] = r.nearest + g.nearest + b.nearest;
    bound = std::min(bound, r.farthest + g.farthest + b.farthest);
  }
  for (std::size_t i = 0; i < among.size(); ++i)
    if (nearest[i] <= bound) io_found.push_back(among[i]);
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
