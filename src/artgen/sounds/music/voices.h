// Voices: keywords that generate a signal.
//
//   tone saw pitch=220..110 voices=3 detune=0.01     a periodic wave by its shape
//   fm pitch=200 ratio=1.41 index=4..0               frequency modulation: one sine modulates another
//   noise brown                                      noise by its color
//   grains click rate=40 pitch=100..900              many short sounds at random times
//   strike bell pitch=110 hardness=0.6               a struck object
//   pluck pitch=55 bright=0.4                        a plucked string
//   throat a..o pitch=90..60 size=1.6 rough=0.5      a human or animal voice
//
// They are implemented in sounds/synthesis.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "artgen/scripts/script.h"
#include "artgen/sounds/curve.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// The rate, length, pitch, and seed that a voice gets from its sound or instrument.
struct VoiceContext {
  double rate = kSynthesisRate;
  double length_s = 1;
  // The frequency in Hz that pitch=1 means: 1 in a sound, the note's frequency in an instrument.
  double pitch = 1;
  std::uint64_t seed = 0;

  // The number of samples that a voice makes.
  std::size_t frames() const { return count_frames(length_s, rate); }
};

// A voice and its keyword. `make` reads its settings, records problems in the arguments, and returns exactly
// context.frames() samples.
struct VoiceKeyword {
  std::string_view keyword;
  Signal (*make)(Arguments& io_arguments, const VoiceContext& context);
};
std::span<const VoiceKeyword> voice_keywords();

// Reads the setting "pitch" and returns it in Hz.
Curve read_pitch(Arguments& io_arguments, const VoiceContext& context, double fallback);

Signal make_tone(Arguments& io_arguments, const VoiceContext& context);
Signal make_fm(Arguments& io_arguments, const VoiceContext& context);
Signal make_noise(Arguments& io_arguments, const VoiceContext& context);
Signal make_grains(Arguments& io_arguments, const VoiceContext& context);
Signal make_strike(Arguments& io_arguments, const VoiceContext& context);
Signal make_pluck(Arguments& io_arguments, const VoiceContext& context);
Signal make_throat(Arguments& io_arguments, const VoiceContext& context);

}  // namespace temblor::artgen
