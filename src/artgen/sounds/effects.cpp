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

// One of the filter's outputs, or some of it, for each sample.
template <typename Pick>
void filter(Arguments& io_arguments, const EffectContext& context, Signal& io_signal, double usual_q,
            Pick pick) {
  constexpr std::size_t kStep = 16;
  const Curve hertz = curve_value(io_arguments, 1000, kHertz, context.length_s);
  const double q = io_arguments.number("q", usual_q, 0.3, 200);
  const std::int32_t times = io_arguments.integer("times", 1, 1, 4);
  for (std::int32_t pass = 0; pass < times; ++pass) {
    StateFilter state;
    for (std::size_t i = 0; i < io_signal.size(); ++i) {
      if (i % kStep == 0) state.set(hertz.at(static_cast<double>(i) / context.rate), q, context.rate);
      io_signal[i] = pick(io_signal[i], state.step(io_signal[i]));
    }
  }
}

void lowpass(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  filter(io_arguments, context, io_signal, 0.7,
         [](double, const StateFilter::Bands& bands) { return bands.low; });
}

void highpass(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  filter(io_arguments, context, io_signal, 0.7,
         [](double, const StateFilter::Bands& bands) { return bands.high; });
}

void bandpass(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  filter(io_arguments, context, io_signal, 2,
         [](double, const StateFilter::Bands& bands) { return bands.band; });
}

void boost(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const double factor = io_arguments.number("by", 2, 0, 20);
  filter(io_arguments, context, io_signal, 1, [factor](double sample, const StateFilter::Bands& bands) {
    return sample + (factor - 1) * bands.band;
  });
}

void vowel(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const std::string vowels = io_arguments.text();
  const double size = io_arguments.number("size", 1, 0.2, 5);
  Mouth(io_arguments, vowels, size, context.length_s).apply(io_signal, context.rate);
}

double peak_of(const Signal& signal) {
  double peak = 0;
  for (const double sample : signal) peak = std::max(peak, std::abs(sample));
  return peak;
}

// As loud as before at its loudest, whatever is done to it.
template <typename Change>
void keeping_peak(Signal& io_signal, Change change) {
  const double before = peak_of(io_signal);
  if (before == 0) return;
  change();
  const double after = peak_of(io_signal);
  if (after == 0) return;
  for (double& sample : io_signal) sample *= before / after;
}

void resonate(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const std::string name = io_arguments.text();
  const SoundMaterial* material = find_material(name);
  if (material == nullptr) {
    io_arguments.complain(fmt::format("'{}' is none of {}", base::quotable(name), material_names()));
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
  const double loudest = peak_of(wet);
  const double gain = loudest > 0 ? peak_of(io_signal) / loudest : 0;
  for (std::size_t i = 0; i < wet.size(); ++i) io_signal[i] += mix * (gain * wet[i] - io_signal[i]);
}

void drive(Arguments& io_arguments, const EffectContext&, Signal& io_signal) {
  const double amount = io_arguments.number(0.1, 100);
  const double lean = io_arguments.number("lean", 0, 0, 1);  // even harmonics
  keeping_peak(io_signal, [&] {
    const double scale = amount / peak_of(io_signal);
    for (double& sample : io_signal) sample = std::tanh(sample * scale + lean) - std::tanh(lean);
  });
}

void crush(Arguments& io_arguments, const EffectContext&, Signal& io_signal) {
  const double steps = std::pow(2.0, io_arguments.number("bits", 8, 1, 16) - 1);
  const auto hold = static_cast<std::size_t>(io_arguments.integer("hold", 1, 1, 100));
  const double peak = peak_of(io_signal);
  if (peak == 0) return;
  for (std::size_t i = 0; i < io_signal.size(); ++i)
    io_signal[i] = i % hold == 0 ? std::round(io_signal[i] / peak * steps) / steps * peak : io_signal[i - 1];
}

// What multiplies it: by how far and how often a sine moves.
template <typename Factor>
void multiply(const Curve& hertz, const EffectContext& context, Signal& io_signal, Factor factor) {
  const Signal rates = hertz.values(io_signal.size(), context.rate);
  double phase = 0;
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    io_signal[i] *= factor(std::sin(kTurn * phase));
    phase += rates[i] / context.rate;
    phase -= std::floor(phase);
  }
}

void ring(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve hertz = curve_value(io_arguments, 100, kHertz, context.length_s);
  const double mix = io_arguments.number("mix", 1, 0, 1);
  multiply(hertz, context, io_signal, [mix](double wave) { return 1 - mix + mix * wave; });
}

void tremble(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve hertz = curve_value(io_arguments, 8, kHertz, context.length_s);
  const double depth = io_arguments.number("depth", 0.5, 0, 1);
  const double sharp = io_arguments.number("sharp", 1, 0.1, 20);  // above 1: short humps
  multiply(hertz, context, io_signal,
           [depth, sharp](double wave) { return 1 - depth + depth * std::pow(0.5 + 0.5 * wave, sharp); });
}

void echo(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const double delay_s = io_arguments.number(0.001, 10);
  const double feedback = io_arguments.number("feedback", 0.4, 0, 0.95);
  const double mix = io_arguments.number("mix", 0.4, 0, 2);
  const double dull_hz = io_arguments.number("dull", 3000, 20, kHertz.highest);
  Signal line(std::max<std::size_t>(1, frames_in(delay_s, context.rate)), 0.0);
  Smoother wall;
  wall.set(dull_hz, context.rate);
  for (std::size_t i = 0; i < io_signal.size(); ++i) {
    double& place = line[i % line.size()];
    const double back = wall.step(place);
    place = io_signal[i] + feedback * back;
    io_signal[i] += mix * back;
  }
}

void room(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  Reverb::Settings settings;
  settings.size = io_arguments.number("size", 0.3, 0, 1);
  settings.ring_s = io_arguments.number("ring", 0.8, 0.05, 20);
  settings.dull_hz = io_arguments.number("dull", 4000, 20, kHertz.highest);
  const double mix = io_arguments.number("mix", 0.3, 0, 2);
  Reverb echoes(settings, context.rate);
  for (double& sample : io_signal) sample += mix * echoes.step(sample).left;
}

void comb(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve hertz = curve_value(io_arguments, 200, {10, 10000, Glide::kByRatio}, context.length_s);
  const double feedback = io_arguments.number("feedback", 0.7, 0, 0.99);
  const double mix = io_arguments.number("mix", 1, 0, 1);
  const Signal rates = hertz.values(io_signal.size(), context.rate);
  const std::size_t longest = frames_in(0.1, context.rate) + 2;
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

void swirl(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
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

void loudness(Arguments& io_arguments, const EffectContext& context, Signal& io_signal) {
  const Curve curve = curve_value(io_arguments, 1, {0, 10}, context.length_s);
  const Signal levels = curve.values(io_signal.size(), context.rate);
  for (std::size_t i = 0; i < io_signal.size(); ++i) io_signal[i] *= levels[i];
}

void reverse(Arguments&, const EffectContext&, Signal& io_signal) {
  std::reverse(io_signal.begin(), io_signal.end());
}

}  // namespace

std::span<const EffectWord> effect_words() {
  static constexpr std::array<EffectWord, 16> kWords = {{
      {"lowpass", lowpass},
      {"highpass", highpass},
      {"bandpass", bandpass},
      {"boost", boost},
      {"vowel", vowel},
      {"resonate", resonate},
      {"drive", drive},
      {"crush", crush},
      {"ring", ring},
      {"tremble", tremble},
      {"echo", echo},
      {"room", room},
      {"comb", comb},
      {"swirl", swirl},
      {"loudness", loudness},
      {"reverse", reverse},
  }};
  return kWords;
}

}  // namespace temblor::artgen
