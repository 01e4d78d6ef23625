// Effects: keywords that change a signal. They stand under a voice, or at the level of the voices, where they
// change everything above them.
//
//   lowpass 4000..200 q=2, highpass 90, bandpass 900 q=4, boost 2500 by=3 q=2
//   vowel o..a size=1.5                        formants of a mouth
//   resonate plate pitch=180 ring=0.4 mix=0.6  resonances of a material
//   drive 4, crush bits=6 hold=3               overdrive; reduced resolution and rate
//   ring 140 mix=0.5, tremble 12 depth=0.6     ring modulation; tremolo
//   echo 0.12 feedback=0.4 mix=0.5, room size=0.4 ring=1.2 mix=0.3, comb 220 feedback=0.8
//   swirl 0.3 depth=0.004 mix=0.5              chorus: mixed with a copy whose delay varies
//   loudness 0..1@0.1..0, reverse
#pragma once

#include <span>
#include <string_view>

#include "artgen/scripts/script.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// The facts about the signal that an effect needs.
struct EffectContext {
  double rate = kSynthesisRate;
  // The length of the voice or sound, for curves. The signal may be longer, so that echoes can end.
  double length_s = 1;
  std::uint64_t seed = 0;
};

// An effect and its keyword. `apply` reads its settings, records problems in the arguments, and changes the
// signal in place without changing its length.
struct EffectKeyword {
  std::string_view keyword;
  void (*apply)(Arguments& io_arguments, const EffectContext& context, Signal& io_signal);
};
std::span<const EffectKeyword> effect_keywords();

}  // namespace temblor::artgen
