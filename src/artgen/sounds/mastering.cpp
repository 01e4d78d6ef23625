#include "artgen/sounds/mastering.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "artgen/sounds/filters.h"

namespace temblor::artgen {
namespace {

// Loudness in dB relative to full scale.
constexpr std::array<SoundClass, 12> kClasses = {{
    {"blast", -8},      // explosions, thunder nearby
    {"weapon", -9},     // shots
    {"impact", -12},    // landing, bouncing, hitting
    {"voice", -11},     // creatures
    {"murmur", -16},    // idle creatures
    {"player", -12},    // the player's own voice
    {"body", -15},      // the player's own steps and splashes
    {"item", -14},      // pickups
    {"signal", -13},    // keys, secrets, messages
    {"machine", -14},   // doors, lifts, buttons
    {"ambience", -18},  // continuous background sounds
    {"menu", -14},
}};

// A limiter without memory: linear up to 0.65, then a hyperbolic tangent that approaches kPeak.
double soft_clip(double sample) {
  constexpr double kKnee = 0.65;
  const double size = std::abs(sample);
  if (size <= kKnee) return sample;
  const double room = kPeak - kKnee;
  return std::copysign(kKnee + room * std::tanh((size - kKnee) / room), sample);
}

// The RMS of the loudest 0.1 seconds of all channels after gain and limiting, by a running sum of squares. A
// shorter signal counts as if it were followed by silence.
double measure_loudest_tenth(std::span<const Signal> channels, double gain, double rate) {
  const std::size_t tenth = count_frames(0.1, rate);
  const std::size_t count = channels.front().size();
  const auto power_at = [&](std::size_t i) {
    double power = 0;
    for (const Signal& channel : channels) {
      const double sample = soft_clip(channel[i] * gain);
      power += sample * sample;
    }
    return power;
  };
  double sum = 0, loudest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += power_at(i);
    if (i >= tenth) sum -= power_at(i - tenth);
    loudest = std::max(loudest, sum);
  }
  return std::sqrt(loudest / static_cast<double>(tenth * channels.size()));
}

// Half a cosine from 0 to 1.
double ease_in(std::size_t i, std::size_t count) {
  return 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(count));
}

}  // namespace

const SoundClass* find_sound_class(std::string_view name) {
  const auto found = std::find_if(kClasses.begin(), kClasses.end(),
                                  [&](const SoundClass& known) { return known.name == name; });
  return found != kClasses.end() ? &*found : nullptr;
}

std::string sound_class_names() {
  std::string names;
  for (const SoundClass& known : kClasses) names.append(names.empty() ? "" : ", ").append(known.name);
  return names;
}

void remove_rumble(Signal& io_signal, double rate) {
  StateVariableFilter filter;
  filter.set(20, 0.7, rate);
  for (double& sample : io_signal) sample = filter.step(sample).high;
}

void remove_rumble_from_loop(Signal& io_signal, double rate) {
  StateVariableFilter filter;
  filter.set(20, 0.7, rate);
  for (const double sample : io_signal) filter.step(sample);
  for (double& sample : io_signal) sample = filter.step(sample).high;
}

void normalize_loudness(std::span<Signal> io_channels, double db, double rate) {
  // The gain may exceed the peak by 12 dB; the limiter would distort more audibly.
  constexpr double kMaxBent = 4;
  double peak = 0;
  for (const Signal& channel : io_channels)
    for (const double sample : channel) peak = std::max(peak, std::abs(sample));
  if (peak == 0) return;
  const double wanted = std::pow(10.0, db / 20), most = kMaxBent * kPeak / peak;
  double gain = 0.1 / peak;
  // The limiter makes the loudness a nonlinear function of the gain, so the gain is found by iteration, to 1
  // %.
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    const double reached = measure_loudest_tenth(io_channels, gain, rate);
    if (std::abs(reached / wanted - 1) < 0.01) break;
    gain = std::min(gain * wanted / reached, most);
  }
  for (Signal& channel : io_channels)
    for (double& sample : channel) sample = soft_clip(sample * gain);
}

void fade_in(Signal& io_signal, double rate) {
  const std::size_t rise = std::min(io_signal.size(), count_frames(0.001, rate));
  for (std::size_t i = 0; i < rise; ++i) io_signal[i] *= ease_in(i, rise);
}

void fade_out(Signal& io_signal, double fade_s, double rate) {
  const std::size_t fall = std::min(io_signal.size(), count_frames(fade_s, rate));
  for (std::size_t i = 0; i < fall; ++i) io_signal[io_signal.size() - 1 - i] *= ease_in(i, fall);
}

void crossfade_loop(Signal& io_signal, std::size_t start, std::size_t end, std::size_t blend) {
  // A crossfade of uncorrelated signals loses half of the power in its middle, one of equal signals none. The
  // correlation of the two parts tells how much to compensate.
  double cross = 0, from_power = 0, to_power = 0;
  for (std::size_t i = 0; i < blend; ++i) {
    const double from = io_signal[end - blend + i], to = io_signal[start - blend + i];
    cross += from * to;
    from_power += from * from;
    to_power += to * to;
  }
  const double powers = std::sqrt(from_power * to_power);
  const double alike = powers > 0 ? std::max(-0.5, cross / powers) : 1;
  for (std::size_t i = 0; i < blend; ++i) {
    const double part = static_cast<double>(i + 1) / static_cast<double>(blend + 1);
    const double rest = 1 - part;
    const double size = std::sqrt(part * part + rest * rest + 2 * alike * part * rest);
    double& sample = io_signal[end - blend + i];
    sample = (sample * rest + io_signal[start - blend + i] * part) / size;
  }
}

Signal halve_rate(const Signal& signal) {
  // A half-band FIR filter: a sinc in which every other tap is zero, with a Blackman window. It has -6 dB at
  // a quarter of the rate and less than -70 dB from 0.29 of the rate.
  constexpr int kReach = 47;
  std::array<double, kReach + 1> taps{};
  taps[0] = 0.5;
  for (int i = 1; i <= kReach; i += 2) {
    const double x = static_cast<double>(i) / (kReach + 1);
    const double window =
        0.42 + 0.5 * std::cos(std::numbers::pi * x) + 0.08 * std::cos(2 * std::numbers::pi * x);
    taps[static_cast<std::size_t>(i)] =
        window * std::sin(0.5 * std::numbers::pi * i) / (std::numbers::pi * i);
  }
  Signal out((signal.size() + 1) / 2);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::size_t at = 2 * k;
    double sum = taps[0] * signal[at];
    for (std::size_t i = 1; i <= kReach; i += 2) {
      if (at >= i) sum += taps[i] * signal[at - i];
      if (at + i < signal.size()) sum += taps[i] * signal[at + i];
    }
    out[k] = sum;
  }
  return out;
}

std::vector<std::int16_t> to_samples(const Signal& signal) {
  std::vector<std::int16_t> samples(signal.size());
  std::transform(signal.begin(), signal.end(), samples.begin(), [](double sample) {
    return static_cast<std::int16_t>(std::lround(std::clamp(sample, -1.0, 1.0) * 32767));
  });
  return samples;
}

void drop_masked_bits(std::span<std::int16_t> io_samples) {
  // Seven bits plus the sign are kept.
  constexpr std::size_t kBlock = 32;
  constexpr int kKeptBits = 7;
  for (std::size_t begin = 0; begin < io_samples.size(); begin += kBlock) {
    const std::span<std::int16_t> block =
        io_samples.subspan(begin, std::min(kBlock, io_samples.size() - begin));
    int loudest = 0;
    for (const int sample : block) loudest = std::max(loudest, std::abs(sample));
    const int dropped =
        std::max(0, static_cast<int>(std::bit_width(static_cast<unsigned>(loudest))) - kKeptBits);
    const int step = 1 << dropped;
    for (std::int16_t& sample : block) {
      // Rounds to the nearest step, but never beyond the largest 16-bit value.
      const int steps = std::min((sample + step / 2) >> dropped, 32767 >> dropped);
      sample = static_cast<std::int16_t>(steps * step);
    }
  }
}

}  // namespace temblor::artgen
