// How much of a pixel's color fog takes, by the pixel's distance z: 1 - exp(-(rate * z)^2), the shape of
// GL's EXP2 fog, in the two forms that the kernels want. Both go by nearness, x = 1 / (rate * z), so that no
// pixel needs a division or an exponential.
#pragma once

namespace temblor::render {

constexpr int kFogSteps = 64;
constexpr int kFogPieces = 16;

// Between these the pieces of the curve lie; outside them fog takes everything or (nearer) nothing.
constexpr float kMinNearness = 0.25f;
constexpr float kMaxNearness = 31.9f;

struct FogCurve {
  // In 64ths, rounded: step k, 0 to 64, covers x from step_ends[k + 1] up to, and without, step_ends[k].
  float step_ends[kFogSteps + 2];

  // In 256ths, plus a half that makes cutting off round: a cubic in x for each half octave, from 2^n to
  // 1.5 * 2^n and on to 2^(n+1): bits 22 to 25 of x as a float say which. Coefficients of x^power are
  // cubic[power]. Off by less than a tenth of a step.
  float cubic[4][kFogPieces];
};

FogCurve make_fog_curve();

}  // namespace temblor::render
