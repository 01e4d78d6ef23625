// The voices `tone` and `fm`: periodic waves, and frequency modulation (J. Chowning, "The Synthesis of
// Complex Audio Spectra by Means of Frequency Modulation", 1973).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/sounds/music/voices.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;

enum class Shape { kSine, kTriangle, kSaw, kSquare };
struct NamedShape {
  std::string_view name;
  Shape shape;
};
constexpr std::array<NamedShape, 4> kShapes = {{{"sine", Shape::kSine},
                                                {"triangle", Shape::kTriangle},
                                                {"saw", Shape::kSaw},
                                                {"square", Shape::kSquare}}};

Shape read_shape(Arguments& io_arguments) {
  const std::string name = io_arguments.text();
  for (const NamedShape& known : kShapes)
    if (known.name == name) return known.shape;
  io_arguments.set_error(fmt::format("'{}' is not one of sine, triangle, saw, square", base::quotable(name)));
  return Shape::kSine;
}

// The difference between a step of height 2 at phase 0 and a band-limited one, in the sample on either side
// of it. Without it, saw and square waves would alias (polynomial band-limited step, PolyBLEP: V. Valimaki
// and A. Huovilainen, 2007). `advance` is the phase increment per sample.
double step_correction(double phase, double advance) {
  if (phase < advance) {
    const double t = phase / advance;
    return t + t - t * t - 1;
  }
  if (phase > 1 - advance) {
    const double t = (phase - 1) / advance;
    return t * t + t + t + 1;
  }
  return 0;
}

// The wave's value at a phase from 0 to 1. `width` is the duty cycle of the square.
double shape_at(Shape shape, double phase, double advance, double width) {
  switch (shape) {
    case Shape::kSine:
      return std::sin(kWholeTurn * phase);
    case Shape::kTriangle:
      return 1 - 4 * std::abs(phase - 0.5);
    case Shape::kSaw:
      return 2 * phase - 1 - step_correction(phase, advance);
    case Shape::kSquare: {
      const double fall = phase >= width ? phase - width : phase - width + 1;
      return (phase < width ? 1.0 : -1.0) + step_correction(phase, advance) - step_correction(fall, advance);
    }
  }
  return 0;
}

// How the pitch varies: periodically (vibrato) and at random (wander), as fractions of it.
struct PitchDrift {
  double vibrato_hz = 5, vibrato = 0, wander = 0;
};

PitchDrift read_pitch_drift(Arguments& io_arguments) {
  PitchDrift drift;
  drift.vibrato = io_arguments.number("vibrato", 0, 0, 1);
  drift.vibrato_hz = io_arguments.number("vibrato_rate", 5, 0.01, 200);
  drift.wander = io_arguments.number("wander", 0, 0, 1);
  return drift;
}

// Wandering interpolates between random values, six per second.
void drift_pitch(Signal& io_hertz, const PitchDrift& drift, const VoiceContext& context, Noise& io_noise) {
  if (drift.vibrato == 0 && drift.wander == 0) return;
  constexpr double kWander_hz = 6;
  const auto pace = static_cast<std::size_t>(context.rate / kWander_hz);
  const double start = io_noise.unit();
  double from = 0, to = 0;
  for (std::size_t i = 0; i < io_hertz.size(); ++i) {
    if (i % pace == 0) {
      from = to;
      to = io_noise.bipolar();
    }
    const double part = static_cast<double>(i % pace) / static_cast<double>(pace);
    const double smooth = part * part * (3 - 2 * part);
    const double turn = start + drift.vibrato_hz * static_cast<double>(i) / context.rate;
    io_hertz[i] *=
        1 + drift.wander * (from + (to - from) * smooth) + drift.vibrato * std::sin(kWholeTurn * turn);
  }
}

}  // namespace

Curve read_pitch(Arguments& io_arguments, const VoiceContext& context, double fallback) {
  Curve curve = read_curve_setting(io_arguments, "pitch", fallback, kHertz, context.length_s);
  curve.scale(context.pitch);
  return curve;
}

// Several voices are detuned symmetrically by up to `detune`, start at random phases, and add up with
// constant power.
Signal make_tone(Arguments& io_arguments, const VoiceContext& context) {
  const Shape shape = read_shape(io_arguments);
  const Curve pitch = read_pitch(io_arguments, context, 1);
  const std::int32_t voices = io_arguments.integer("voices", 1, 1, 12);
  const double detune = io_arguments.number("detune", 0.006, 0, 1);
  const double width = io_arguments.number("width", 0.5, 0.02, 0.98);
  const PitchDrift drift = read_pitch_drift(io_arguments);
  const Signal hertz = pitch.values(context.frames(), context.rate);
  Signal sum(hertz.size(), 0.0);
  for (std::int32_t voice = 0; voice < voices; ++voice) {
    Noise noise(context.seed + static_cast<std::uint64_t>(voice));
    const double side = voices > 1 ? 2.0 * voice / (voices - 1) - 1 : 0;
    Signal own = hertz;
    drift_pitch(own, drift, context, noise);
    double phase = voices > 1 ? noise.unit() : 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double advance = std::min(own[i] * (1 + side * detune) / context.rate, 0.45);
      sum[i] += shape_at(shape, phase, advance, width) / std::sqrt(static_cast<double>(voices));
      phase += advance;
      phase -= std::floor(phase);
    }
  }
  return sum;
}

// `ratio` is the modulator's frequency relative to the carrier, `index` the peak phase deviation in radians.
Signal make_fm(Arguments& io_arguments, const VoiceContext& context) {
  const Curve pitch = read_pitch(io_arguments, context, 1);
  const Curve ratio =
      read_curve_setting(io_arguments, "ratio", 1, {0.001, 100, Glide::kExponential}, context.length_s);
  const Curve index = read_curve_setting(io_arguments, "index", 1, {0, 100}, context.length_s);
  const PitchDrift drift = read_pitch_drift(io_arguments);
  Noise noise(context.seed);
  Signal hertz = pitch.values(context.frames(), context.rate);
  drift_pitch(hertz, drift, context, noise);
  const Signal ratios = ratio.values(hertz.size(), context.rate);
  const Signal depths = index.values(hertz.size(), context.rate);
  Signal samples(hertz.size());
  double carrier = 0, modulator = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = std::sin(kWholeTurn * carrier + depths[i] * std::sin(kWholeTurn * modulator));
    carrier += hertz[i] / context.rate;
    modulator += hertz[i] * ratios[i] / context.rate;
    carrier -= std::floor(carrier);
    modulator -= std::floor(modulator);
  }
  return samples;
}

}  // namespace temblor::artgen
