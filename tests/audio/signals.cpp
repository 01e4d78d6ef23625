#include "audio/signals.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace temblor::test {

namespace {
constexpr double kTurn = 2 * std::numbers::pi;
}

formats::Wav sine_wav(double frequency_hz, double amplitude, std::uint32_t frames_per_second,
                      std::size_t frames) {
  formats::Wav wav{
      .frames_per_second = frames_per_second, .channels = 1, .bits = 16, .samples = {}, .loop = {}};
  for (std::size_t i = 0; i < frames; ++i) {
    const double phase = kTurn * frequency_hz * static_cast<double>(i) / frames_per_second;
    wav.samples.push_back(static_cast<std::int16_t>(std::lround(32767 * amplitude * std::sin(phase))));
  }
  return wav;
}

audio::SoundPtr sine_sound(double frequency_hz, double amplitude, std::size_t frames) {
  audio::Sound sound{"sine", {}, std::nullopt};
  for (std::size_t i = 0; i < frames; ++i)
    sound.samples.push_back(static_cast<float>(
        amplitude * std::sin(kTurn * frequency_hz * static_cast<double>(i) / audio::kFramesPerSecond)));
  return std::make_shared<const audio::Sound>(std::move(sound));
}

audio::SoundPtr looping(audio::SoundPtr sound) {
  audio::Sound copy = *sound;
  copy.loop = audio::SoundLoop{0, copy.samples.size()};
  return std::make_shared<const audio::Sound>(std::move(copy));
}

audio::SoundPtr constant_sound(float value, std::size_t frames) {
  return std::make_shared<const audio::Sound>(
      audio::Sound{"constant", std::vector<float>(frames, value), std::nullopt});
}

double measure_amplitude(std::span<const float> samples, double frequency_hz) {
  const double step = kTurn * frequency_hz / audio::kFramesPerSecond;
  std::complex<double> sum = 0;
  double weights = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double place = static_cast<double>(i);
    const double weight = 0.5 - 0.5 * std::cos(kTurn * (place + 0.5) / static_cast<double>(samples.size()));
    sum += weight * static_cast<double>(samples[i]) * std::polar(1.0, -step * place);
    weights += weight;
  }
  return 2 * std::abs(sum) / weights;
}

double rest_db(std::span<const float> samples, double frequency_hz) {
  const double step = kTurn * frequency_hz / audio::kFramesPerSecond;
  double cc = 0, ss = 0, cs = 0, xc = 0, xs = 0, power = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double c = std::cos(step * static_cast<double>(i)), s = std::sin(step * static_cast<double>(i));
    const double x = static_cast<double>(samples[i]);
    cc += c * c, ss += s * s, cs += c * s, xc += x * c, xs += x * s, power += x * x;
  }
  const double determinant = cc * ss - cs * cs;
  const double a = (xc * ss - xs * cs) / determinant, b = (xs * cc - xc * cs) / determinant;
  double rest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double phase = step * static_cast<double>(i);
    const double difference = static_cast<double>(samples[i]) - a * std::cos(phase) - b * std::sin(phase);
    rest += difference * difference;
  }
  return 10 * std::log10(rest / power);
}

double to_db(double ratio) {
  return 20 * std::log10(ratio);
}

double rms(std::span<const float> samples) {
  double sum = 0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return samples.empty() ? 0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

double largest_step(std::span<const float> samples) {
  double largest = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    largest =
        std::max(largest, std::abs(static_cast<double>(samples[i]) - static_cast<double>(samples[i - 1])));
  return largest;
}

double peak(std::span<const float> samples) {
  double largest = 0;
  for (const float sample : samples) largest = std::max(largest, std::abs(static_cast<double>(sample)));
  return largest;
}

Stereo rendered(audio::Mixer& io_mixer, std::size_t frames) {
  std::vector<float> samples(2 * frames);
  io_mixer.render(samples);
  Stereo stereo;
  for (std::size_t i = 0; i < frames; ++i) {
    stereo.left.push_back(samples[2 * i]);
    stereo.right.push_back(samples[2 * i + 1]);
  }
  return stereo;
}

Stereo rendered_from_start(audio::Mixer& io_mixer, std::size_t frames) {
  Stereo stereo = rendered(io_mixer, frames + audio::Mixer::kDelay_frames);
  for (std::vector<float>* channel : {&stereo.left, &stereo.right})
    channel->erase(channel->begin(), channel->begin() + audio::Mixer::kDelay_frames);
  return stereo;
}

audio::Scene quiet_scene() {
  audio::Scene scene;
  scene.listener.entity = 1;
  scene.volumes.sounds = 1;
  return scene;
}

}  // namespace temblor::test
