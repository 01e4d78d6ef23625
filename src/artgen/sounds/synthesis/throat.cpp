// Voices: a glottis that opens and shuts (the pulse of A. Rosenberg, "Effect of glottal pulse shape on the
// quality of natural vowels", 1971), breath, and a mouth. Roughness makes it a beast's: periods and pulses
// differ, and every second pulse is weaker, as in growls.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/sounds/filters.h"
#include "artgen/sounds/music/voices.h"
#include "artgen/sounds/synthesis/vowels.h"

namespace temblor::artgen {
namespace {

struct ThroatSettings {
  double breath = 0, rough = 0, growl_hz = 0;
};

// The flow through it at a phase of its period, 0 to 1.
double flow(double phase) {
  constexpr double kOpening = 0.4, kClosed = 0.6;
  if (phase < kOpening) return 0.5 - 0.5 * std::cos(std::numbers::pi * phase / kOpening);
  if (phase < kClosed) return std::cos(0.5 * std::numbers::pi * (phase - kOpening) / (kClosed - kOpening));
  return 0;
}

Signal glottis(const Signal& hertz, const ThroatSettings& settings, double rate, Noise& io_noise) {
  Signal samples(hertz.size());
  double phase = 0, before = 0, stretch = 1, strength = 1, growl = 0, breath = 0;
  bool second = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double advance = hertz[i] * stretch / rate;
    phase += advance;
    if (phase >= 1) {
      phase -= std::floor(phase);
      second = !second;
      stretch = 1 + 0.12 * settings.rough * io_noise.both();
      strength = (1 - 0.5 * settings.rough * io_noise.unit()) * (second ? 1 - 0.6 * settings.rough : 1);
    }
    const double open = flow(phase) * strength;
    // What is heard is how the flow changes; in a period it falls by 1 within a fifth.
    const double pulse = (open - before) / std::max(advance, 1e-6) * 0.15;
    before = open;
    breath += 0.5 * (io_noise.both() - breath);
    growl += settings.growl_hz * (1 + 0.3 * settings.rough * io_noise.both()) / rate;
    const double flutter = settings.growl_hz > 0 ? 0.55 + 0.45 * std::sin(2 * std::numbers::pi * growl) : 1.0;
    samples[i] = (pulse * (1 - settings.breath) + breath * settings.breath * (0.4 + open)) * flutter;
  }
  return samples;
}

}  // namespace

Signal make_throat(Arguments& io_arguments, const VoiceContext& context) {
  const std::string vowels = io_arguments.text();
  const Curve pitch = pitch_setting(io_arguments, context, 110);
  ThroatSettings settings;
  settings.breath = io_arguments.number("breath", 0.1, 0, 1);
  settings.rough = io_arguments.number("rough", 0.1, 0, 1);
  settings.growl_hz = io_arguments.number("growl", 0, 0, 200);
  const double size = io_arguments.number("size", 1, 0.2, 5);
  const Mouth mouth(io_arguments, vowels, size, context.length_s);
  Noise noise(context.seed);
  Signal samples = glottis(pitch.values(context.frames(), context.rate), settings, context.rate, noise);
  mouth.apply(samples, context.rate);
  // Flesh swallows what a hard edge has of the highest.
  Smoother cheeks;
  cheeks.set(3000 / std::sqrt(size), context.rate);
  for (double& sample : samples) sample = cheeks.step(sample);
  return samples;
}

}  // namespace temblor::artgen
