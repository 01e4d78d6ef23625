// What changes a signal: the words of a script that stand under a voice, or under a sound for all of it.
//
//   lowpass 4000..200 q=2      highpass 90      bandpass 900 q=4      boost 2500 by=3 q=2
//   vowel o..a size=1.5        a mouth in front of it
//   resonate plate pitch=180 ring=0.4 mix=0.6
//   drive 4                    overdriven      crush bits=6 hold=3      as early machines
//   ring 140 mix=0.5           multiplied by a sine      tremble 12 depth=0.6      louder and softer
//   echo 0.12 feedback=0.4 mix=0.5      room size=0.4 ring=1.2 mix=0.3      comb 220 feedback=0.8
//   swirl 0.3 depth=0.004 mix=0.5       mixed with itself, a moment before that moves
//   loudness 0..1@0.1..0       reverse
#pragma once

#include <span>
#include <string_view>

#include "artgen/scripts/script.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

struct EffectContext {
  double rate = kSynthesisRate;
  double length_s = 1;  // of the voice; what it sets going may ring on behind
  std::uint64_t seed = 0;
};

struct EffectWord {
  std::string_view word;
  void (*apply)(Arguments& io_arguments, const EffectContext& context, Signal& io_signal);
};
std::span<const EffectWord> effect_words();

}  // namespace temblor::artgen
