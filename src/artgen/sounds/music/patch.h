// A sound, or a note of an instrument, from the lines of its script: voices, what changes each of them under
// it, and what changes all.
//
//   strike plate pitch=300 at=0.1 for=0.5 level=0.4 attack=0.01 decay=0.3
//     lowpass 2000
//   noise white times=3 every=0.08 scatter=0.5
//   room size=0.4
//
// Every voice knows at= (s), for= (s; else to the end), level=, attack= (s), decay= (s until it has lost 60
// dB; else it lasts), fade= (s, at its end), times= every= (s) scatter= (how much repetitions differ) and
// seed=.
#pragma once

#include <cstdint>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/signal.h"
#include "base/result.h"

namespace temblor::artgen {

struct PatchContext {
  double rate = kSynthesisRate;
  double length_s = 1;  // of all of it
  double voice_s = 1;   // that voices without for= last
  double pitch = 1;     // Hz that pitch=1 means
  std::uint64_t seed = 0;
};

// frames_in(length_s) samples of the voices among `lines`, each with its effects; effects among `lines`
// change what stands above them.
base::Result<Signal> render_patch(const std::vector<ScriptLine>& lines, const PatchContext& context);

}  // namespace temblor::artgen
