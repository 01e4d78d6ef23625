#include "artgen/sounds/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/sounds/curve.h"
#include "artgen/sounds/filters.h"
#include "artgen/sounds/materials.h"
#include "artgen/sounds/reverb.h"
#include "artgen/sounds/synthesis/vowels.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Runs a state-variable filter with a moving frequency, `times` times. `pick` selects or mixes its outputs.
template <typename Pick>
void apply_filter(Arguments& io_arguments, const EffectContext& context, Signal& io_signal, double default_q,
                  Pick pick) {
  constexpr std::size_t kStep = 16;
  const Curve hertz = read_curve_value(io_arguments, 1000, kHertz, context.length_s);
  const double q = io_arguments.number("q", default_q, 0.3, 200);
  const std::int32_t times = io_arguments.integer("times", 1, 1, 4);
  for (std::int32_t pass = 0; pass < times; ++pass) {
    StateVariableFilter state;
    for (std::size_t i = 0; i < io_signal.size(); ++i) {
      if (i % kStep == 0) state.set(hertz.at(static_cast<double>(i) / context.rate), q, context.rate);
      io_signal[i] = pick(io_signal[i], state.step(io_signal[i]));
    }
  }
}

void apply_lowpass(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  apply_filter(io_arguments, context, io_signal, 0.7,
               [](double, const StateVariableFilter::Bands& bands) { return bands.low; });
}

void apply_highpass(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  apply_filter(io_arguments, context, io_signal, 0.7,
               [](double, const StateVariableFilter::Bands& bands) { return bands.high; });
}

void apply_bandpass(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  apply_filter(io_arguments, context, io_signal, 2,
               [](double, const StateVariableFilter::Bands& bands) { return bands.band; });
}

// A peak filter: adds a multiple of the band around the frequency.
void apply_boost(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const double factor = io_arguments.number("by", 2, 0, 20);
  apply_filter(io_arguments, context, io_signal, 1,
               [factor](double sample, const StateVariableFilter::Bands& bands) {
                 return sample + (factor - 1) * bands.band;
               });
}

void apply_vowel(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const std::string vowels = io_arguments.text();
  const double size = io_arguments.number("size", 1, 0.2, 5);
  VowelFilter(io_arguments, vowels, size, context.length_s).apply(io_signal, context.rate);
}

double find_peak(const Signal& signal) {
  double peak = 0;
  for (const double sample : signal) peak = std::max(peak, std::abs(sample));
  return peak;
}

// Runs `change` and then scales the signal so that its peak is the same as before.
template <typename Change>
void keep_peak(Signal& io_signal, Change change) {
  const double before = find_peak(io_signal);
  if (before == 0) return;
  change();
  const double after = find_peak(io_signal);
  if (after == 0) return;
  for (double& sample : io_signal) sample *= before / after;
}

// Normalizes the resonances to the peak of the dry signal before mixing.
void apply_resonate(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const std::string name = io_arguments.text();
  const SoundMaterial* material = find_material(name);
  if (material == nullptr) {
    io_arguments.set_error(fmt::format("'{}' is not one of {}", base::quotable(name), material_names()));
    material = &materials().front();
  }
  Resonances::Settings settings;
  settings.pitch = io_arguments.number("pitch", 200, 1, kHertz.highest);
  settings.ring_s = io_arguments.number("ring", material->ring_s, 0.005, 60);
  settings.spread = io_arguments.number("spread", 0, 0, 0.5);
  settings.seed = context.seed;
  const double mix = io_arguments.number("mix", 1, 0, 1);
  Resonances resonances(*material, settings, context.rate);
  Signal wet(io_signal.size());
  std::transform(io_signal.begin(), io_signal.end(), wet.begin(),
                 [&](double sample) { return resonances.step(sample); });
  const double loudest = find_peak(wet);
  const double gain = loudest > 0 ? find_peak(io_signal) / loudest : 0;
  for (std::size_t i = 0; i < wet.size(); ++i) io_signal[i] += mix * (gain * wet[i] - io_signal[i]);
}

// Saturation with a hyperbolic tangent. `lean` shifts the signal, which makes the curve asymmetric and adds
// even harmonics.
void apply_drive(Arguments& io_arguments, const EffectContext&, Signal& io_signal) {
  const double amount = io_arguments.number(0.1, 100);
  const double lean = io_arguments.number("lean", 0, 0, 1);
  keep_peak(io_signal, [&] {
    const double scale = amount / find_peak(io_signal);
    for (double& sample : io_signal) sample = std::tanh(sample * scale + lean) - std::tanh(lean);
  });
}

// Quantizes relative to the peak and repeats samples (sample and hold), like early digital sound chips.
void apply_crush(Arguments& io_arguments, const EffectContext&, Signal& io_signal) {
  const double steps = std::pow(2.0, io_arguments.number("bits", 8, 1, 16) - 1);
  const auto hold = static_cast<std::size_t>(io_arguments.integer("hold", 1, 1, 100));
  const double peak = find_peak(io_signal);
  if (peak == 0) return;
  for (std::size_t i = 0; i < io_signal.size(); ++i)
    io_signal[i] = i % hold == 0 ? std::round(io_signal[i] / peak * steps) / steps * peak : io_signal[i - 1];
}

// Multiplies the signal by factor(sine), where the sine's frequency follows a curve.
template <typename Factor>
void modulate(const Curve& hertz, const EffectContext& context, Signal& io_signal, Factor factor) {
  const Signal rates = hertz.values(io_signal.size(), context.rate);
  double phase = 0;
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    io_signal[i] *= factor(std::sin(kTurn * phase));
    phase += rates[i] / context.rate;
    phase -= std::floor(phase);
  }
}

void apply_ring(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve hertz = read_curve_value(io_arguments, 100, kHertz, context.length_s);
  const double mix = io_arguments.number("mix", 1, 0, 1);
  modulate(hertz, context, io_signal, [mix](double wave) { return 1 - mix + mix * wave; });
}

void apply_tremble(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve hertz = read_curve_value(io_arguments, 8, kHertz, context.length_s);
  const double depth = io_arguments.number("depth", 0.5, 0, 1);
  // Above 1: short pulses.
  const double sharp = io_arguments.number("sharp", 1, 0.1, 20);
  modulate(hertz, context, io_signal,
           [depth, sharp](double wave) { return 1 - depth + depth * std::pow(0.5 + 0.5 * wave, sharp); });
}

// A delay line with a lowpass in its feedback path, so that later echoes are duller.
void apply_echo(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const double delay_s = io_arguments.number(0.001, 10);
  const double feedback = io_arguments.number("feedback", 0.4, 0, 0.95);
  const double mix = io_arguments.number("mix", 0.4, 0, 2);
  const double damping_hz = io_arguments.number("dull", 3000, 20, kHertz.highest);
  Signal line(std::max<std::size_t>(1, count_frames(delay_s, context.rate)), 0.0);
  OnePoleLowpass lowpass;
  lowpass.set(damping_hz, context.rate);
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    double& place = line[i % line.size()];
    const double back = lowpass.step(place);
    place = io_signal[i] + feedback * back;
    io_signal[i] += mix * back;
  }
}

// Mono: only the left channel of the reverberation.
void apply_room(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  Reverb::Settings settings;
  settings.size = io_arguments.number("size", 0.3, 0, 1);
  settings.ring_s = io_arguments.number("ring", 0.8, 0.05, 20);
  settings.damping_hz = io_arguments.number("dull", 4000, 20, kHertz.highest);
  const double mix = io_arguments.number("mix", 0.3, 0, 2);
  Reverb echoes(settings, context.rate);
  for (double& sample : io_signal) sample += mix * echoes.step(sample).left;
}

// A comb filter with feedback. The delay is one period of a moving frequency, with linear interpolation
// between samples.
void apply_comb(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve hertz = read_curve_value(io_arguments, 200, {10, 10000, Glide::kExponential}, context.length_s);
  const double feedback = io_arguments.number("feedback", 0.7, 0, 0.99);
  const double mix = io_arguments.number("mix", 1, 0, 1);
  const Signal rates = hertz.values(io_signal.size(), context.rate);
  // The period of the lowest frequency, 10 Hz, plus the neighbor for interpolation.
  const std::size_t longest = count_frames(0.1, context.rate) + 2;
  Signal line(longest, 0.0);
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    const double period = std::max(1.0, context.rate / rates[i]);
    const auto whole = static_cast<std::size_t>(period);
    const double rest = period - static_cast<double>(whole);
    const double back =
        line[(i + longest - whole) % longest] * (1 - rest) + line[(i + longest - whole - 1) % longest] * rest;
    const double wet = io_signal[i] + feedback * back;
    line[i % longest] = wet;
    io_signal[i] += mix * (wet * (1 - feedback) * 2 - io_signal[i]);
  }
}

// A chorus: a copy of the signal with a delay that a sine modulates.
void apply_swirl(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const double hertz = io_arguments.number(0.01, 20);
  const double depth_s = io_arguments.number("depth", 0.003, 0.0001, 0.03);
  const double mix = io_arguments.number("mix", 0.5, 0, 1);
  const Signal dry = io_signal;
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    const double wave = 0.5 + 0.5 * std::sin(kTurn * hertz * static_cast<double>(i) / context.rate);
    const double at = static_cast<double>(i) - depth_s * context.rate * (0.1 + wave);
    const auto whole = static_cast<std::size_t>(std::max(0.0, at));
    const double rest = std::max(0.0, at) - static_cast<double>(whole);
    const double moved = at < 0 ? 0 : dry[whole] * (1 - rest) + dry[std::min(whole + 1, i)] * rest;
    io_signal[i] += mix * (moved - 0.3 * io_signal[i]);
  }
}

// An envelope.
void apply_loudness(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve curve = read_curve_value(io_arguments, 1, {0, 10}, context.length_s);
  const Signal levels = curve.values(io_signal.size(), context.rate);
  for (std::size_t i = 0; i < io_signal.size(); ++i) io_signal[i] *= levels[i];
}

void apply_reverse(Arguments&, const EffectContext&, Signal& io_signal) {
  std::reverse(io_signal.begin(), io_signal.end());
}

}  // namespace

std::span<const EffectKeyword> effect_keywords() {
  static constexpr std::array<EffectKeyword, 16> kKeywords = {{
      {"lowpass", apply_lowpass},
      {"highpass", apply_highpass},
      {"bandpass", apply_bandpass},
      {"boost", apply_boost},
      {"vowel", apply_vowel},
      {"resonate", apply_resonate},
      {"drive", apply_drive},
      {"crush", apply_crush},
      {"ring", apply_ring},
      {"tremble", apply_tremble},
      {"echo", apply_echo},
      {"room", apply_room},
      {"comb", apply_comb},
      {"swirl", apply_swirl},
      {"loudness", apply_loudness},
      {"reverse", apply_reverse},
  }};
  return kKeywords;
}

}  // namespace temblor::artgen
