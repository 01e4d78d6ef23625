// The voices `noise` and `grains`.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/sounds/filters.h"
#include "artgen/sounds/music/voices.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// -3 dB per octave, approximated by a sum of lowpass filters two octaves apart, each with half the gain of
// the one below.
Signal make_pink_noise(std::size_t count, double rate, Noise& io_noise) {
  constexpr std::array<double, 6> kCorners = {20, 80, 320, 1280, 5120, 20480};
  std::array<OnePoleLowpass, kCorners.size()> smoothers;
  for (std::size_t k = 0; k < kCorners.size(); ++k) smoothers[k].set(kCorners[k], rate);
  Signal samples(count);
  for (double& sample : samples) {
    const double white = io_noise.bipolar();
    double share = 8;
    for (OnePoleLowpass& smoother : smoothers) {
      sample += smoother.step(white) * share;
      share *= 0.5;
    }
    sample *= 0.8;
  }
  return samples;
}

// -6 dB per octave above 30 Hz.
Signal make_brown_noise(std::size_t count, double rate, Noise& io_noise) {
  OnePoleLowpass smoother;
  smoother.set(30, rate);
  Signal samples(count);
  for (double& sample : samples) sample = smoother.step(io_noise.bipolar()) * 16;
  return samples;
}

enum class GrainKind { kSine, kNoise, kClick };

// The settings of the voice `grains`; each grain gets random values from the ranges.
struct Grains {
  GrainKind kind = GrainKind::kSine;
  std::pair<double, double> pitch, length_s;
  // The factor by which the pitch changes during a grain.
  double rise = 1;
};

// Adds one grain. If it exceeds the end of the signal, it is cut off.
void add_grain(const Grains& grains, double rate, std::size_t start, Noise& io_noise, Signal& io_samples) {
  const double pitch = io_noise.log_uniform(grains.pitch.first, grains.pitch.second);
  const double length_s = io_noise.log_uniform(grains.length_s.first, grains.length_s.second);
  const double loudness = 0.2 + 0.8 * io_noise.unit() * io_noise.unit();
  const auto count = std::max<std::size_t>(8, count_frames(length_s, rate));
  // A sine that starts abruptly clicks, so it rises over a fifth of the grain. Noise and clicks rise within a
  // millisecond.
  const double attack_frames =
      grains.kind == GrainKind::kSine ? 0.2 * static_cast<double>(count) : 0.001 * rate;
  StateVariableFilter filter;
  filter.set(pitch, 3, rate);
  double phase = 0;
  for (std::size_t i = 0; i < count && start + i < io_samples.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    const double attack = std::min(1.0, static_cast<double>(i) / attack_frames);
    const double fall = grains.kind == GrainKind::kClick ? std::exp(-7 * part) : (1 - part) * (1 - part);
    phase += pitch * (1 + (grains.rise - 1) * part) / rate;
    const double source = grains.kind == GrainKind::kSine ? std::sin(2 * std::numbers::pi * phase)
                                                          : 2 * filter.step(io_noise.bipolar()).band;
    io_samples[start + i] += source * attack * fall * loudness;
  }
}

}  // namespace

Signal make_noise(Arguments& io_arguments, const VoiceContext& context) {
  const std::string color = io_arguments.text();
  Noise noise(context.seed);
  if (color == "pink") return make_pink_noise(context.frames(), context.rate, noise);
  if (color == "brown") return make_brown_noise(context.frames(), context.rate, noise);
  if (color != "white")
    io_arguments.set_error(fmt::format("'{}' is not one of white, pink, brown", base::quotable(color)));
  Signal samples(context.frames());
  for (double& sample : samples) sample = noise.bipolar();
  return samples;
}

Signal make_grains(Arguments& io_arguments, const VoiceContext& context) {
  Grains grains;
  const std::string kind = io_arguments.text();
  if (kind == "noise")
    grains.kind = GrainKind::kNoise;
  else if (kind == "click")
    grains.kind = GrainKind::kClick;
  else if (kind != "sine")
    io_arguments.set_error(fmt::format("'{}' is not one of sine, noise, click", base::quotable(kind)));
  const Curve rate = read_curve_setting(io_arguments, "rate", 30, {0, 5000}, context.length_s);
  grains.pitch = io_arguments.range("pitch", {200, 800});
  grains.length_s = io_arguments.range("grain", {0.02, 0.06});
  grains.rise = io_arguments.number("rise", 1, 0.05, 20);
  if (std::min(grains.pitch.first, grains.pitch.second) <= 0 ||
      std::max(grains.pitch.first, grains.pitch.second) > kHertz.highest)
    io_arguments.set_error("pitch= must be above 0 and at most 20000");
  if (std::min(grains.length_s.first, grains.length_s.second) <= 0 ||
      std::max(grains.length_s.first, grains.length_s.second) > 5)
    io_arguments.set_error("grain= must be above 0 and at most 5 s");
  Signal samples(context.frames(), 0.0);
  Noise noise(context.seed);
  // Grains start at random: in each sample with probability rate / sample rate, a Poisson process.
  const Signal rates = rate.values(samples.size(), context.rate);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (noise.unit() < rates[i] / context.rate) add_grain(grains, context.rate, i, noise, samples);
  return samples;
}

}  // namespace temblor::artgen
