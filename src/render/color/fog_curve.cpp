#include "render/color/fog_curve.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/check.h"

namespace temblor::render {

namespace {

constexpr std::size_t kTerms = 4;
using Polynomial = std::array<double, kTerms>;  // coefficients, beginning with that of x^0

// The exact curve. expm1 keeps precision where fog is thin.
double rounded_share_256(double nearness) {
  return 256 * -std::expm1(-1 / (nearness * nearness)) + 0.5;
}

// Interpolates the curve at the Chebyshev nodes of the interval, which nearly minimizes the largest error, by
// Newton's divided differences.
Polynomial cubic_between(double low, double high) {
  std::array<double, kTerms> x{}, difference{};
  for (std::size_t i = 0; i < kTerms; ++i) {
    const double node = std::cos((2.0 * static_cast<double>(i) + 1) * std::numbers::pi / (2.0 * kTerms));
    x[i] = (low + high) / 2 + (high - low) / 2 * node;
    difference[i] = rounded_share_256(x[i]);
  }
  for (std::size_t order = 1; order < kTerms; ++order)
    for (std::size_t i = kTerms - 1; i >= order; --i)
      difference[i] = (difference[i] - difference[i - 1]) / (x[i] - x[i - order]);
  Polynomial sum{};
  for (std::size_t i = kTerms; i-- > 0;) {  // sum * (x - x[i]) + difference[i]
    for (std::size_t power = kTerms - 1; power > 0; --power) sum[power] = sum[power - 1] - x[i] * sum[power];
    sum[0] = difference[i] - x[i] * sum[0];
  }
  return sum;
}

}  // namespace

FogCurve make_fog_curve() {
  FogCurve curve{};
  for (int step = 1; step <= kFogSteps; ++step)
    curve.step_ends[step] = static_cast<float>(1 / std::sqrt(-std::log1p(-(step - 0.5) / kFogSteps)));
  curve.step_ends[0] = std::numeric_limits<float>::infinity();
  curve.step_ends[kFogSteps + 1] = -std::numeric_limits<float>::infinity();
  for (float low = kMinNearness; low < kMaxNearness; low *= 2)
    for (const double part : {1.0, 1.5}) {
      const double from = part * static_cast<double>(low);
      const Polynomial cubic = cubic_between(from, part == 1.0 ? 1.5 * from : from / 0.75);
      const std::uint32_t piece = std::bit_cast<std::uint32_t>(static_cast<float>(from)) >> 22 & 15;
      for (std::size_t power = 0; power < kTerms; ++power)
        curve.cubic[power][piece] = static_cast<float>(cubic[power]);
    }
  return curve;
}

FogCells make_fog_cells(const float* step_end_depths) {
  const auto cell_number = [](float depth) { return std::bit_cast<std::int32_t>(depth) >> FogCells::kShift; };
  FogCells cells{};
  cells.first = cell_number(step_end_depths[kFogSteps]);
  cells.count = cell_number(step_end_depths[1]) - cells.first + 1;
  CHECK(cells.count <= FogCells::kMaxCells, "{} cells", cells.count);
  int step = kFogSteps;
  for (std::int32_t cell = 0; cell < cells.count; ++cell) {
    const bool has_end = cell_number(step_end_depths[step]) == cells.first + cell;
    cells.ends[cell] = has_end ? step_end_depths[step] : -std::numeric_limits<float>::infinity();
    step -= has_end ? 1 : 0;
    cells.steps[cell] = step;
  }
  CHECK(step == 0, "{} steps are left", step);
  return cells;
}

std::int32_t find_fog_cell(const FogCells& cells, float depth) {
  return std::clamp((std::bit_cast<std::int32_t>(depth) >> FogCells::kShift) - cells.first, 0,
                    cells.count - 1);
}

}  // namespace temblor::render
