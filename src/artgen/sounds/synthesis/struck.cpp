// What is struck and what is plucked: resonances that a hammer sets going, and a string (K. Karplus and
// A. Strong, 1983) as a delay that feeds back what it gives, dulled.
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

const SoundMaterial& read_material(Arguments& io_arguments) {
  const std::string name = io_arguments.text();
  if (const SoundMaterial* found = find_material(name)) return *found;
  io_arguments.complain(fmt::format("'{}' is none of {}", base::quotable(name), material_names()));
  return materials().front();
}

// A push of one hump, the harder the shorter, and the rattle of the two surfaces in it.
Signal hammer(double hardness, std::size_t count, double rate, Noise& io_noise) {
  const double length_s = 0.008 * std::pow(0.02, hardness);
  const std::size_t push = std::clamp<std::size_t>(frames_in(length_s, rate), 2, count);
  Signal samples(count, 0.0);
  for (std::size_t i = 0; i < push; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(push);
    const double hump = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * part);
    samples[i] = hump * (1 + 0.7 * hardness * io_noise.both()) * 2 / static_cast<double>(push);
  }
  return samples;
}

}  // namespace

Signal make_strike(Arguments& io_arguments, const VoiceContext& context) {
  const SoundMaterial& material = read_material(io_arguments);
  const Curve pitch = pitch_setting(io_arguments, context, 440);
  Resonances::Settings settings;
  settings.pitch = pitch.at(0);
  settings.ring_s = io_arguments.number("ring", material.ring_s, 0.005, 60);
  settings.spread = io_arguments.number("spread", 0, 0, 0.5);
  settings.seed = context.seed;
  const double hardness = io_arguments.number("hardness", 0.7, 0, 1);
  Noise noise(context.seed);
  Signal samples = hammer(hardness, context.frames(), context.rate, noise);
  Resonances resonances(material, settings, context.rate);
  for (double& sample : samples) sample = resonances.step(sample);
  return samples;
}

Signal make_pluck(Arguments& io_arguments, const VoiceContext& context) {
  const double pitch = pitch_setting(io_arguments, context, 110).at(0);
  const double ring_s = io_arguments.number("ring", 3, 0.01, 60);
  const double bright = io_arguments.number("bright", 0.5, 0, 1);
  const double period = std::max(4.0, context.rate / pitch);
  const auto whole = static_cast<std::size_t>(period - 0.5);
  const double rest = period - 0.5 - static_cast<double>(whole);
  const double kept = std::pow(10.0, -3 * period / (ring_s * context.rate));
  Noise noise(context.seed);
  Smoother finger;
  finger.set(pitch * std::pow(2.0, 1 + 6 * bright), context.rate);
  Signal line(whole + 1);
  for (double& sample : line) sample = finger.step(noise.both());
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
