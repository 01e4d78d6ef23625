// What sounds by itself: the words of a script that make a signal out of nothing.
//
//   tone saw pitch=220..110 voices=3 detune=0.01     periodic, by its shape
//   fm pitch=200 ratio=1.41 index=4..0               a sine whose phase another sine moves
//   noise brown                                      by its color
//   grains click rate=40 pitch=100..900              many small sounds at random times
//   strike bell pitch=110 hardness=0.6               something that rings is struck
//   pluck pitch=55 bright=0.4                        a string is plucked
//   throat a..o pitch=90..60 size=1.6 rough=0.5      a voice
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "artgen/scripts/script.h"
#include "artgen/sounds/curve.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

struct VoiceContext {
  double rate = kSynthesisRate;
  double length_s = 1;
  double pitch = 1;  // Hz that a script's pitch=1 means: 1, or a note's
  std::uint64_t seed = 0;

  std::size_t frames() const { return frames_in(length_s, rate); }
};

// A word, and what it sounds like: as many samples as the context has frames. Reads its own settings; what is
// wrong is a complaint.
struct VoiceWord {
  std::string_view word;
  Signal (*make)(Arguments& io_arguments, const VoiceContext& context);
};
std::span<const VoiceWord> voice_words();

// The setting "pitch", in Hz.
Curve pitch_setting(Arguments& io_arguments, const VoiceContext& context, double otherwise);

Signal make_tone(Arguments& io_arguments, const VoiceContext& context);
Signal make_fm(Arguments& io_arguments, const VoiceContext& context);
Signal make_noise(Arguments& io_arguments, const VoiceContext& context);
Signal make_grains(Arguments& io_arguments, const VoiceContext& context);
Signal make_strike(Arguments& io_arguments, const VoiceContext& context);
Signal make_pluck(Arguments& io_arguments, const VoiceContext& context);
Signal make_throat(Arguments& io_arguments, const VoiceContext& context);

}  // namespace temblor::artgen
