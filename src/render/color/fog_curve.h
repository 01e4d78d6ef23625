// The fog curve: the share of a pixel's color that fog takes, by the distance z. The curve is 1 - exp(-(rate
// * z)^2), the shape of OpenGL's EXP2 fog. It is stored in the two forms that the kernels need, both as
// functions of the nearness x = 1 / (rate * z), so that no pixel needs a division or an exponential.
#pragma once

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

}  // namespace temblor::render
