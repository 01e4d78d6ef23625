// Sounds of known content, and what is in the samples that come out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "audio/mixer.h"
#include "audio/sound.h"
#include "formats/sounds/wav.h"

namespace temblor::test {

// 16 bits, one channel.
formats::Wav sine_wav(double frequency_hz, double amplitude, std::uint32_t frames_per_second,
                      std::size_t frames);
// Already at the mixer's rate, and without anything done to its end.
audio::SoundPtr sine_sound(double frequency_hz, double amplitude, std::size_t frames);
audio::SoundPtr looping(audio::SoundPtr sound);
audio::SoundPtr constant_sound(float value, std::size_t frames);

// The amplitude of that frequency in the samples, at the mixer's rate, as a Hann window sees it: what lies
// four lines of the window or more away counts less than a thousandth of a percent.
double measure_amplitude(std::span<const float> samples, double frequency_hz);
// What is left of the samples' power without that frequency, as a share of it, in dB: the sine that fits best
// is taken out, by least squares.
double rest_db(std::span<const float> samples, double frequency_hz);
double to_db(double ratio);
double rms(std::span<const float> samples);
// The largest difference between neighbors.
double largest_step(std::span<const float> samples);
double peak(std::span<const float> samples);

struct Stereo {
  std::vector<float> left, right;
};
// The next frames of the mixer.
Stereo rendered(audio::Mixer& io_mixer, std::size_t frames);
// As rendered(), but as if the mixer had no delay: for a mixer that has rendered nothing yet.
Stereo rendered_from_start(audio::Mixer& io_mixer, std::size_t frames);

// Sounds at full volume, the listener in the middle, looking along +x: right is -y.
audio::Scene quiet_scene();

}  // namespace temblor::test
