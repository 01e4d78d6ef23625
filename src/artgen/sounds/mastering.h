// From a signal to samples of a file: no constant part, as loud as its kind is, no click at either end, loops
// without a seam.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// How loud sounds of a kind are: the root mean square of the loudest tenth of a second, in dB below full
// scale.
struct SoundClass {
  std::string_view name;
  double loudest_db = -14;
};
const SoundClass* find_sound_class(std::string_view name);
std::string sound_class_names();

constexpr double kPeak = 0.97;  // nothing is louder

// Takes away what is below 20 Hz; of what goes round, too.
void remove_rumble(Signal& io_signal, double rate);
void remove_rumble_around(Signal& io_signal, double rate);
// The loudest tenth of a second comes to `db`, but for sounds that would have to be turned up by more than
// peaks can be bent down by: those end softer. Silence stays. Channels, each as long as the first, count
// together.
void bring_to_level(std::span<Signal> io_channels, double db, double rate);
// The first millisecond rises from nothing; the last `fade_s` fall to it.
void soften_start(Signal& io_signal, double rate);
void soften_end(Signal& io_signal, double fade_s, double rate);
// Blends what leads up to `end` into what leads up to `start`, over `blend` samples, so that `start` follows
// on `end` as it follows on what is before it. blend <= start < end <= size.
void blend_loop(Signal& io_signal, std::size_t start, std::size_t end, std::size_t blend);

// Each second sample, those frequencies taken away that half the rate cannot hold.
Signal halve_rate(const Signal& signal);
std::vector<std::int16_t> to_samples(const Signal& signal);
// Keeps of every 32 samples only the bits that the loudest among them begins with, seven and the sign. What
// goes is less than a 128th of that one, 45 dB below the sound wherever it is, and is as good as noise: files
// pack into half. Method: near-instantaneous companding, as in NICAM (EN 300 163), which keeps ten bits.
void drop_hidden_bits(std::span<std::int16_t> io_samples);

}  // namespace temblor::artgen
