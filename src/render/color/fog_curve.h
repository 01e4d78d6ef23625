// The fog curve: the share of a pixel's color that fog takes, by the distance z. The curve is 1 - exp(-(rate
// * z)^2), the shape of OpenGL's EXP2 fog. It is stored in the two forms that the kernels need, both as
// functions of the nearness x = 1 / (rate * z), so that no pixel needs a division or an exponential.
#pragma once

#include <cstdint>

namespace temblor::render {

constexpr int kFogSteps = 64;
constexpr int kFogPieces = 16;

// The range of the polynomial pieces. Farther away fog takes everything, nearer it takes nothing.
constexpr float kMinNearness = 0.25f;
constexpr float kMaxNearness = 31.9f;

struct FogCurve {
  // For indexed frames, in 64ths: step k, 0 to 64, covers x from step_ends[k + 1] (inclusive) to step_ends[k]
  // (exclusive).
  float step_ends[kFogSteps + 2];

  // For rgb frames, in 256ths plus one half, so that truncation rounds: a cubic polynomial in x for each half
  // octave, from 2^n to 1.5 * 2^n and from there to 2^(n+1). Bits 22 to 25 of x as a float select the
  // polynomial; cubic[power] holds the coefficients of x^power. The error is below a tenth of a step.
  float cubic[4][kFogPieces];
};

FogCurve make_fog_curve();

// Finds the step at a depth without a search. The bits of a positive float, without the lowest 17, number its
// cells: 64 in each octave. A step is at least 1/33 octave wide, and a cell at most 1/44, so that a cell
// holds at most one end of a step. For perspective only: the depths of steps must be positive.
struct FogCells {
  static constexpr int kShift = 17, kMaxCells = 320;

  std::int32_t first, count;      // number of the first cell, and how many cells there are
  float ends[kMaxCells];          // the end in the cell; -infinity if there is none
  std::int32_t steps[kMaxCells];  // the step at this end and nearer
};

// `step_end_depths`: FogCurve::step_ends, times a positive factor.
FogCells make_fog_cells(const float* step_end_depths);

// The cell of a depth, from 0. Depths outside of all cells belong to the first or the last one.
std::int32_t find_fog_cell(const FogCells& cells, float depth);

}  // namespace temblor::render
