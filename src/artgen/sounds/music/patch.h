// Renders a patch: a sound, or one note of an instrument, from the lines of its script. Voices (voices.h) are
// added up; effects (effects.h) under a voice change that voice, and effects between voices change everything
// above them.
//
//   strike plate pitch=300 at=0.1 for=0.5 level=0.4 attack=0.01 decay=0.3
//     lowpass 2000
//   noise white times=3 every=0.08 scatter=0.5
//   room size=0.4
//
// All voices accept at= (start, s), for= (length, s; by default to the end), level=, attack= (s), decay=
// (time in s to lose 60 dB; by default none), fade= (s, at the end), times= every= scatter= (repetitions and
// how much they differ), and seed=.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/signal.h"
#include "base/result.h"

namespace temblor::artgen {

// The rate, lengths, pitch, and seed that a patch gets from its sound or instrument.
struct PatchContext {
  double rate = kSynthesisRate;
  // The length of the whole result.
  double length_s = 1;
  // The length of voices without for=.
  double voice_s = 1;
  // The frequency in Hz that pitch=1 means.
  double pitch = 1;
  std::uint64_t seed = 0;
};

// Returns count_frames(length_s) samples. The result depends only on the lines and the context. Fails for
// unknown keywords and invalid settings.
base::Result<Signal> render_patch(const std::vector<ScriptLine>& lines, const PatchContext& context);

}  // namespace temblor::artgen
