// The last steps from a signal to the samples of a file: removes very low frequencies, normalizes the
// loudness, fades the ends, closes loops, and quantizes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// How loud a kind of sound is: the RMS of its loudest 0.1 seconds, in dB relative to full scale. All sounds
// of a class are equally loud, so that the mix of the game does not depend on how a script was written.
struct SoundClass {
  std::string_view name;
  double loudest_db = -14;
};
// Null if no class has the name.
const SoundClass* find_sound_class(std::string_view name);
// For error messages.
std::string sound_class_names();

// The limit of all samples after normalize_loudness.
constexpr double kPeak = 0.97;

// Removes frequencies below 20 Hz, which speakers cannot reproduce. The second function is for signals that
// loop as a whole: the filter's state at the start is the one at the end.
void remove_rumble(Signal& io_signal, double rate);
void remove_rumble_from_loop(Signal& io_signal, double rate);
// Scales the channels together so that their loudest 0.1 seconds reach `db`, with peaks softly limited to
// kPeak. The gain is limited so that peaks are compressed by at most 12 dB; sounds with higher peaks end up
// softer. Silence stays silent. All channels must have the same length.
void normalize_loudness(std::span<Signal> io_channels, double db, double rate);
// Fades the first millisecond in and the last `fade_s` out, so that there is no click at either end.
void fade_in(Signal& io_signal, double rate);
void fade_out(Signal& io_signal, double fade_s, double rate);
// Closes a loop from `start` to `end`: blends the last `blend` samples before `end` into those before
// `start`, so that playback continues from `end` to `start` without a step. Requires blend <= start < end <=
// size.
void crossfade_loop(Signal& io_signal, std::size_t start, std::size_t end, std::size_t blend);

// Keeps every second sample after removing the frequencies that the halved rate cannot represent.
Signal halve_rate(const Signal& signal);
// Full scale is +-32767; values outside are clamped.
std::vector<std::int16_t> to_samples(const Signal& signal);
// In each block of 32 samples, clears the bits below the top seven of the loudest sample. The error is below
// 1/128 of that sample (-42 dB), sounds like noise, and is masked by the sound itself; compressed packages
// shrink by half. The method is near-instantaneous companding, as in NICAM (EN 300 163), which keeps ten
// bits.
void drop_masked_bits(std::span<std::int16_t> io_samples);

}  // namespace temblor::artgen
