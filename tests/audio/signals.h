// Generates test signals and measures the mixer's output.
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

// The frames of a second.
inline constexpr std::size_t kSecond = audio::kFramesPerSecond;

// A mono sound of 16 bits.
formats::Wav sine_wav(double frequency_hz, double amplitude, std::uint32_t frames_per_second,
                      std::size_t frames);
// Already at the mixer's rate, without a fade at its end.
audio::SoundPtr sine_sound(double frequency_hz, double amplitude, std::size_t frames);
audio::SoundPtr looping(audio::SoundPtr sound);
audio::SoundPtr constant_sound(float value, std::size_t frames);

// The amplitude of one frequency, at the mixer's rate, measured with a Hann window. Frequencies four or more
// spectral lines away contribute less than 0.001 %.
double measure_amplitude(std::span<const float> samples, double frequency_hz);
// Removes the best-fitting sine (least squares) and returns the remaining power relative to the total, in dB.
double rest_db(std::span<const float> samples, double frequency_hz);
double to_db(double ratio);
double rms(std::span<const float> samples);
// The largest difference between neighboring samples.
double largest_step(std::span<const float> samples);
double peak(std::span<const float> samples);

struct Stereo {
  std::vector<float> left, right;
};
// Renders the next frames.
Stereo rendered(audio::Mixer& io_mixer, std::size_t frames);
// Like rendered(), without the mixer's delay. The mixer must not have rendered anything yet.
Stereo rendered_from_start(audio::Mixer& io_mixer, std::size_t frames);

// Sounds at full volume; the listener is at the origin and looks along +x, so its right is -y.
audio::Scene quiet_scene();

}  // namespace temblor::test
