// Tests resampling and loops by their samples.
#include "audio/sound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "audio/signals.h"

namespace temblor::test {
namespace {

using audio::kFramesPerSecond;
using audio::SoundPtr;

// Leaves out both ends, where the filter includes silence around the sound.
std::span<const float> middle(const SoundPtr& sound) {
  const std::size_t edge = sound->samples.size() / 8;
  return std::span(sound->samples).subspan(edge, sound->samples.size() - 2 * edge);
}

struct Tone {
  std::uint32_t frames_per_second;
  double frequency_hz;
};

class ResampledSine : public ::testing::TestWithParam<Tone> {};

TEST_P(ResampledSine, KeepsFrequencyAndLevelWithoutArtifacts) {
  const Tone tone = GetParam();
  const SoundPtr sound =
      audio::make_sound(sine_wav(tone.frequency_hz, 0.5, tone.frames_per_second, tone.frames_per_second),
                        "sine")
          .value();
  EXPECT_NEAR(static_cast<double>(sound->samples.size()), kFramesPerSecond, 1);
  EXPECT_NEAR(to_db(measure_amplitude(middle(sound), tone.frequency_hz) / 0.5), 0, 0.1);
  // Quantization to 16 bits alone leaves noise at -92 dB at this level.
  EXPECT_LT(rest_db(middle(sound), tone.frequency_hz), -80);
}

INSTANTIATE_TEST_SUITE_P(Rates, ResampledSine,
                         ::testing::Values(Tone{11025, 440}, Tone{11025, 4000}, Tone{22050, 1000},
                                           Tone{22050, 9000}, Tone{44100, 1000}, Tone{44100, 18000},
                                           Tone{48000, 1000}, Tone{64000, 1000}, Tone{96000, 15000},
                                           Tone{8000, 100}));

TEST(Resampling, RemovesImages) {
  const SoundPtr sound = audio::make_sound(sine_wav(4000, 0.5, 11025, 11025), "sine").value();
  for (const double image_hz : {11025.0 - 4000, 11025.0 + 4000, 22050.0 - 4000})
    EXPECT_LT(to_db(measure_amplitude(middle(sound), image_hz) / 0.5), -80) << image_hz;
}

TEST(Resampling, FiltersFrequenciesAboveTheLimit) {
  const SoundPtr sound = audio::make_sound(sine_wav(30000, 0.5, 96000, 96000), "sine").value();
  EXPECT_LT(to_db(measure_amplitude(middle(sound), kFramesPerSecond - 30000.0) / 0.5), -60);
  EXPECT_LT(to_db(rms(middle(sound))), -60);
}

TEST(Resampling, MixesChannelsToMono) {
  formats::Wav wav = sine_wav(1000, 0.5, kFramesPerSecond, 4800);
  wav.channels = 2;
  std::vector<std::int16_t> both;
  for (const std::int16_t sample : wav.samples) both.insert(both.end(), {sample, 0});
  wav.samples = both;
  const SoundPtr sound = audio::make_sound(wav, "stereo").value();
  ASSERT_EQ(sound->samples.size(), 4800u);
  for (std::size_t i = 0; i < 4000; ++i)
    ASSERT_FLOAT_EQ(sound->samples[i], static_cast<float>(both[2 * i]) / 65536);
}

TEST(Resampling, EightBitSoundsHaveTheSameLevel) {
  formats::Wav wav{
      .frames_per_second = kFramesPerSecond, .channels = 1, .bits = 8, .samples = {}, .loop = {}};
  wav.samples.assign(1000, -128);
  const SoundPtr sound = audio::make_sound(wav, "low").value();
  EXPECT_EQ(sound->samples[0], -1.0f);
  EXPECT_EQ(sound->samples[500], -1.0f);
  EXPECT_EQ(sound->samples.back(), 0.0f) << "the end fades to silence";
  EXPECT_LT(largest_step(sound->samples), 0.03);
}

// The samples that a voice would play: the beginning, then the loop repeatedly.
std::vector<float> unroll(const audio::Sound& sound, std::size_t count) {
  std::vector<float> samples;
  std::size_t position = 0;
  while (samples.size() < count) {
    samples.push_back(sound.samples[position++]);
    if (position == sound.loop->end) position = sound.loop->start;
  }
  return samples;
}

TEST(Loop, LoopedSineStaysASine) {
  // The loop has 50 whole periods from sample 1000 on. The noise before it must not leak into it.
  for (const std::uint32_t rate : {11025u, 22050u, 44100u, 48000u, 64000u}) {
    const double frequency_hz = 50.0 * rate / 2205;
    formats::Wav wav = sine_wav(frequency_hz, 0.5, rate, 1000 + 2205);
    for (std::size_t i = 0; i < 900; ++i) wav.samples[i] = static_cast<std::int16_t>(i * 7919 % 20000);
    wav.loop = formats::WavLoop{1000, 3205};
    const SoundPtr sound = audio::make_sound(wav, "loop").value();
    ASSERT_TRUE(sound->loop);
    const std::vector<float> samples = unroll(*sound, 100000);
    const double ratio = static_cast<double>(kFramesPerSecond) / rate;
    const double length = static_cast<double>(sound->loop->end - sound->loop->start);
    EXPECT_NEAR(length, 2205 * ratio, 0.5);
    // Rounding the loop to whole samples changes its pitch by the same ratio.
    const double got_hz = 50.0 * kFramesPerSecond / length;
    const auto from = static_cast<std::size_t>(1100 * ratio);
    EXPECT_LT(rest_db(std::span(samples).subspan(from), got_hz), -80) << rate;
  }
}

TEST(Loop, RepeatsTheSamplesBetweenItsPoints) {
  formats::Wav wav{
      .frames_per_second = kFramesPerSecond, .channels = 1, .bits = 16, .samples = {}, .loop = {}};
  for (int i = 0; i < 600; ++i) wav.samples.push_back(static_cast<std::int16_t>(i * 10));
  wav.loop = formats::WavLoop{200, 500};
  const std::vector<float> samples = unroll(*audio::make_sound(wav, "loop").value(), 2000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t source = i < 500 ? i : 200 + (i - 200) % 300;
    ASSERT_EQ(samples[i], static_cast<float>(source * 10) / 32768) << i;
  }
}

TEST(Loop, OneSampleLoopsWork) {
  for (const std::uint32_t rate : {1000u, 11025u, 48000u, 192000u}) {
    formats::Wav wav = sine_wav(100, 0.5, rate, 300);
    wav.samples.back() = 12345;
    wav.loop = formats::WavLoop{299, 300};
    const SoundPtr sound = audio::make_sound(wav, "loop").value();
    ASSERT_TRUE(sound->loop);
    EXPECT_NEAR(sound->samples[sound->loop->start], 12345 / 32768.0, 1e-3) << rate;
  }
}

// At every rate, a short loop is repeated to at least 1000 samples, and the sound stays short.
TEST(Loop, ShortLoopsAreRepeatedWhenLoaded) {
  for (const std::uint32_t rate : {1000u, 11025u, 48000u, 192000u})
    for (const std::uint32_t length : {1u, 2u, 3u, 7u, 10u, 100u}) {
      formats::Wav wav = sine_wav(100, 0.5, rate, rate / 2);
      wav.loop = formats::WavLoop{rate / 2 - length, rate / 2};
      const SoundPtr sound = audio::make_sound(wav, "loop").value();
      ASSERT_TRUE(sound->loop);
      const std::size_t loop = sound->loop->end - sound->loop->start;
      EXPECT_GE(loop, 1000u) << rate << ", " << length;
      EXPECT_NEAR(static_cast<double>(sound->loop->start) / kFramesPerSecond, 0.5, 0.07)
          << rate << ", " << length;
      EXPECT_LT(sound->samples.size(), kFramesPerSecond * 7u / 10) << rate << ", " << length;
      // A whole number of repetitions, within 0.1 %.
      const double times = static_cast<double>(loop) * rate / kFramesPerSecond / length;
      EXPECT_NEAR(times / std::round(times), 1, 1e-3) << rate << ", " << length;
    }
}

TEST(Loop, AddedLoopHasNoStep) {
  const formats::Wav wav = sine_wav(333.3, 0.5, 11025, 11025);
  const SoundPtr once = audio::make_sound(wav, "once").value();
  const SoundPtr always = audio::make_sound(wav, "always", audio::Repeats::kAlways).value();
  EXPECT_FALSE(once->loop);
  ASSERT_TRUE(always->loop);
  const double natural = largest_step(middle(once));
  EXPECT_LT(largest_step(unroll(*always, 200000)), 1.5 * natural);
  EXPECT_FALSE(audio::make_sound({}, "empty", audio::Repeats::kAlways).value()->loop);
}

TEST(MakeSound, TooLongIsAnError) {
  formats::Wav wav{.frames_per_second = 1000, .channels = 1, .bits = 8, .samples = {}, .loop = {}};
  wav.samples.assign(60 * 1000 + 1, 0);
  const auto sound = audio::make_sound(wav, "long");
  ASSERT_FALSE(sound.ok());
  EXPECT_EQ(sound.error().code, base::ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace temblor::test
