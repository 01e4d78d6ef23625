// The voice `throat`: glottal pulses (A. Rosenberg, "Effect of Glottal Pulse Shape on the Quality of Natural
// Vowels", 1971) and breath noise through a vowel filter. `rough` makes periods and pulses irregular and
// every second pulse weaker, as in growls, so that the voice sounds like an animal's.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/sounds/filters.h"
#include "artgen/sounds/music/voices.h"
#include "artgen/sounds/synthesis/vowels.h"

namespace temblor::artgen {
namespace {

// `breath` and `rough` are from 0 to 1; growl_hz is the rate of an amplitude flutter, 0 for none.
struct ThroatSettings {
  double breath = 0, rough = 0, growl_hz = 0;
};

// The flow of air at a phase (0 to 1) of its period: opens slowly, closes quickly, and stays closed.
double glottal_flow(double phase) {
  constexpr double kOpening = 0.4, kClosed = 0.6;
  if (phase < kOpening) return 0.5 - 0.5 * std::cos(std::numbers::pi * phase / kOpening);
  if (phase < kClosed) return std::cos(0.5 * std::numbers::pi * (phase - kOpening) / (kClosed - kOpening));
  return 0;
}

// `hertz` is the pitch for each sample.
Signal make_glottal_pulses(const Signal& hertz, const ThroatSettings& settings, double rate,
                           Noise& io_noise) {
  Signal samples(hertz.size());
  double phase = 0, before = 0, stretch = 1, strength = 1, growl = 0, breath = 0;
  bool second = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double advance = hertz[i] * stretch / rate;
    phase += advance;
    if (phase >= 1) {
      phase -= std::floor(phase);
      second = !second;
      stretch = 1 + 0.12 * settings.rough * io_noise.bipolar();
      strength = (1 - 0.5 * settings.rough * io_noise.unit()) * (second ? 1 - 0.6 * settings.rough : 1);
    }
    const double open = glottal_flow(phase) * strength;
    // Radiation at the mouth differentiates the flow. The factor keeps the result near 1: the flow falls by 1
    // within a fifth of the period.
    const double pulse = (open - before) / std::max(advance, 1e-6) * 0.15;
    before = open;
    breath += 0.5 * (io_noise.bipolar() - breath);
    growl += settings.growl_hz * (1 + 0.3 * settings.rough * io_noise.bipolar()) / rate;
    const double flutter = settings.growl_hz > 0 ? 0.55 + 0.45 * std::sin(2 * std::numbers::pi * growl) : 1.0;
    samples[i] = (pulse * (1 - settings.breath) + breath * settings.breath * (0.4 + open)) * flutter;
  }
  return samples;
}

}  // namespace

Signal make_throat(Arguments& io_arguments, const VoiceContext& context) {
  const std::string vowels = io_arguments.text();
  const Curve pitch = read_pitch(io_arguments, context, 110);
  ThroatSettings settings;
  settings.breath = io_arguments.number("breath", 0.1, 0, 1);
  settings.rough = io_arguments.number("rough", 0.1, 0, 1);
  settings.growl_hz = io_arguments.number("growl", 0, 0, 200);
  const double size = io_arguments.number("size", 1, 0.2, 5);
  const VowelFilter mouth(io_arguments, vowels, size, context.length_s);
  Noise noise(context.seed);
  Signal samples =
      make_glottal_pulses(pitch.values(context.frames(), context.rate), settings, context.rate, noise);
  mouth.apply(samples, context.rate);
  // Tissue absorbs high frequencies.
  OnePoleLowpass cheeks;
  cheeks.set(3000 / std::sqrt(size), context.rate);
  for (double& sample : samples) sample = cheeks.step(sample);
  return samples;
}

}  // namespace temblor::artgen
