// The voices `strike` and `pluck`: resonances that a hammer excites (materials.h), and a string as a delay
// line with a lowpass in its feedback (K. Karplus and A. Strong, "Digital Synthesis of Plucked-String and
// Drum Timbres", 1983).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "artgen/sounds/filters.h"
#include "artgen/sounds/materials.h"
#include "artgen/sounds/music/voices.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// After an error, returns the first material.
const SoundMaterial& read_material(Arguments& io_arguments) {
  const std::string name = io_arguments.text();
  if (const SoundMaterial* found = find_material(name)) return *found;
  io_arguments.set_error(fmt::format("'{}' is not one of {}", base::quotable(name), material_names()));
  return materials().front();
}

// The force of a hammer: one raised cosine, which is shorter for harder hammers, with noise from the
// surfaces. Its integral does not depend on its length.
Signal make_hammer_blow(double hardness, std::size_t count, double rate, Noise& io_noise) {
  const double length_s = 0.008 * std::pow(0.02, hardness);
  const std::size_t push = std::clamp<std::size_t>(count_frames(length_s, rate), 2, count);
  Signal samples(count, 0.0);
  for (std::size_t i = 0; i < push; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(push);
    const double hump = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * part);
    samples[i] = hump * (1 + 0.7 * hardness * io_noise.bipolar()) * 2 / static_cast<double>(push);
  }
  return samples;
}

}  // namespace

Signal make_strike(Arguments& io_arguments, const VoiceContext& context) {
  const SoundMaterial& material = read_material(io_arguments);
  const Curve pitch = read_pitch(io_arguments, context, 440);
  Resonances::Settings settings;
  settings.pitch = pitch.at(0);
  settings.ring_s = io_arguments.number("ring", material.ring_s, 0.005, 60);
  settings.spread = io_arguments.number("spread", 0, 0, 0.5);
  settings.seed = context.seed;
  const double hardness = io_arguments.number("hardness", 0.7, 0, 1);
  Noise noise(context.seed);
  Signal samples = make_hammer_blow(hardness, context.frames(), context.rate, noise);
  Resonances resonances(material, settings, context.rate);
  for (double& sample : samples) sample = resonances.step(sample);
  return samples;
}

// The pitch is that of the start; strings do not glide.
Signal make_pluck(Arguments& io_arguments, const VoiceContext& context) {
  const double pitch = read_pitch(io_arguments, context, 110).at(0);
  const double ring_s = io_arguments.number("ring", 3, 0.01, 60);
  const double bright = io_arguments.number("bright", 0.5, 0, 1);
  // The averaging lowpass delays by half a sample, so the delay line is shorter by that. `rest` is its
  // fractional part, which linear interpolation provides.
  const double period = std::max(4.0, context.rate / pitch);
  const auto whole = static_cast<std::size_t>(period - 0.5);
  const double rest = period - 0.5 - static_cast<double>(whole);
  const double kept = std::pow(10.0, -3 * period / (ring_s * context.rate));
  Noise noise(context.seed);
  // The string starts as noise; a duller one sounds as if it were plucked with a softer finger.
  OnePoleLowpass finger;
  finger.set(pitch * std::pow(2.0, 1 + 6 * bright), context.rate);
  Signal line(whole + 1);
  for (double& sample : line) sample = finger.step(noise.bipolar());
  Signal samples(context.frames());
  double last = 0;
  std::size_t at = 0;
  for (double& sample : samples) {
    const std::size_t next = at + 1 < line.size() ? at + 1 : 0;
    sample = line[at] * rest + line[next] * (1 - rest);
    line[at] = kept * 0.5 * (sample + last);
    last = sample;
    at = next;
  }
  return samples;
}

}  // namespace temblor::artgen
