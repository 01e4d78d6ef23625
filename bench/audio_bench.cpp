// Measures the cost of sound in seconds of CPU time per second of sound: 10 ms are one percent of a core.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "audio/mixer.h"
#include "audio/mixing/mix_kernels.h"
#include "formats/sounds/wav.h"

namespace temblor::bench {
namespace {

constexpr std::size_t kSecond = audio::kFramesPerSecond;
constexpr std::size_t kPiece = 512;  // the block that a device asks for

audio::SoundPtr hum(double frequency_hz) {
  audio::Sound sound{"hum", {}, audio::SoundLoop{0, kSecond}};
  for (std::size_t i = 0; i < kSecond; ++i)
    sound.samples.push_back(
        static_cast<float>(0.5 * std::sin(6.283185307 * frequency_hz * static_cast<double>(i) / kSecond)));
  return std::make_shared<const audio::Sound>(std::move(sound));
}

// All voices are audible, and the listener turns and walks 72 times per second.
void mix_voices(benchmark::State& state) {
  audio::Mixer mixer;
  audio::Scene scene;
  scene.listener.entity = 1;
  mixer.set_scene(scene, 0);
  audio::SoundEvents events;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const auto place = static_cast<float>(i);
    events.statics.push_back({hum(100 + 10 * static_cast<double>(i)),
                              {300 * std::cos(place), 300 * std::sin(place), 0},
                              2 / static_cast<float>(state.range(0)),
                              1});
  }
  mixer.handle_events(events);
  std::vector<float> out(2 * kPiece), music(2 * kPiece, 0.1f);
  double time_s = 0;
  for (auto _ : state) {
    for (std::size_t done = 0; done < kSecond; done += kPiece) {
      time_s += static_cast<double>(kPiece) / kSecond;
      scene.listener.origin_world.x = static_cast<float>(100 * std::sin(time_s));
      scene.listener.right = {static_cast<float>(std::cos(time_s)), static_cast<float>(std::sin(time_s)), 0};
      mixer.set_scene(scene, kPiece);
      mixer.render(out, music);
    }
    benchmark::ClobberMemory();
  }
  state.counters["percent_of_core"] =
      benchmark::Counter(static_cast<double>(state.iterations()) / 100,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(mix_voices)
    ->Name("audio/voices")
    ->Arg(0)
    ->Arg(32)
    ->Arg(128)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond);

// Only the inner loop, for one second of one voice.
template <auto Mix>
void mix_kernel(benchmark::State& state) {
  const audio::SoundPtr sound = hum(440);
  std::vector<float> left(256), right(256);
  for (auto _ : state) {
    for (std::size_t at = 0; at + left.size() <= kSecond; at += left.size())
      Mix({sound->samples.data() + at, left.size(), left.data(), right.data(), 0.5f, 1e-6f, 0.25f, 1e-6f});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kSecond));
}
void mix_plainly(const audio::MixJob& job) {
  audio::mix_scalar(job);
}
BENCHMARK(mix_kernel<mix_plainly>)->Name("audio/kernel/plain");
BENCHMARK(mix_kernel<audio::mix_simd>)->Name("audio/kernel/vector");

// Loads one second of sound in the format of game files.
void resample(benchmark::State& state) {
  formats::Wav wav{.frames_per_second = static_cast<std::uint32_t>(state.range(0)),
                   .channels = 1,
                   .bits = 16,
                   .samples = {},
                   .loop = {}};
  for (std::int64_t i = 0; i < state.range(0); ++i)
    wav.samples.push_back(static_cast<std::int16_t>(i * 7919 % 20000));
  for (auto _ : state) benchmark::DoNotOptimize(audio::make_sound(wav, "second"));
}
BENCHMARK(resample)
    ->Name("audio/load")
    ->Arg(11025)
    ->Arg(22050)
    ->Arg(44100)
    ->Arg(48000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace temblor::bench
