// The ratios of bars with free ends, membranes, and plates come from acoustics (Rayleigh, "The Theory of
// Sound", 1877; Fletcher and Rossing, "The Physics of Musical Instruments", 1998). Those of the bell are its
// usual tuning (hum, prime, tierce, quint, nominal). The other materials are made up in the same manner.
#include "artgen/sounds/materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace temblor::artgen {
namespace {

// Name, ratios, ring_s, damping; in alphabetical order.
const std::array<SoundMaterial, 11>& table() {
  static const std::array<SoundMaterial, 11> materials = {{
      {"bar", {1, 2.756, 5.404, 8.933, 13.34, 18.64}, 1.6, 0.7},
      {"bell", {0.5, 1, 1.19, 1.506, 2, 2.514, 2.662, 3.011, 4.166, 5.433, 6.796, 8.215}, 5, 0.8},
      {"bone", {1, 1.82, 2.93, 4.7, 6.1, 9.2}, 0.12, 0.5},
      {"chain", {1, 1.37, 2.11, 2.76, 3.3, 4.05, 5.4, 6.7, 8.9}, 0.25, 0.4},
      {"crystal", {1, 1.004, 2.32, 2.33, 4.25, 4.27, 6.63, 9.38}, 2.5, 0.6},
      {"drum", {1, 1.594, 2.136, 2.296, 2.653, 2.918, 3.156, 3.5}, 0.6, 0.8},
      {"flesh", {1, 1.4, 2.2, 3.1}, 0.09, 1},
      {"glass", {1, 2.32, 4.25, 6.63, 9.38, 12.22}, 0.5, 0.5},
      {"plate", {1, 1.73, 2.33, 3.03, 3.91, 4.11, 5.19, 6.3, 6.71, 7.9, 9.7, 11.3, 13.2, 15.1}, 0.9, 0.5},
      {"stone", {1, 1.47, 2.09, 2.56, 3.39, 4.61, 5.8, 7.3}, 0.14, 0.6},
      {"wood", {1, 2.572, 4.644, 6.984, 9.723, 12}, 0.18, 0.6},
  }};
  return materials;
}

}  // namespace

std::span<const SoundMaterial> materials() {
  return table();
}

const SoundMaterial* find_material(std::string_view name) {
  const auto found = std::find_if(table().begin(), table().end(),
                                  [&](const SoundMaterial& material) { return material.name == name; });
  return found != table().end() ? &*found : nullptr;
}

std::string material_names() {
  std::string names;
  for (const SoundMaterial& material : table()) names.append(names.empty() ? "" : ", ").append(material.name);
  return names;
}

Resonances::Resonances(const SoundMaterial& material, const Settings& settings, double rate) {
  Noise noise(settings.seed);
  double sum = 0;
  for (const double ratio : material.ratios) {
    const double mistuned = 1 + settings.spread * noise.bipolar();
    const double frequency = settings.pitch * ratio * mistuned;
    if (frequency > 0.45 * rate) continue;
    const double ring_s = settings.ring_s * std::pow(ratio, -material.damping);
    const double loss = std::pow(10.0, -3 / std::max(1.0, ring_s * rate));
    const double angle = 2 * std::numbers::pi * frequency / rate;
    // High modes are weaker.
    const double share = std::pow(ratio, -0.3);
    // The impulse response of two poles at radius `loss` is a sine divided by sin(angle); the gain cancels
    // that.
    modes_.push_back({2 * loss * std::cos(angle), -loss * loss, share * std::sin(angle), 0, 0});
    sum += share;
  }
  for (Mode& mode : modes_) mode.gain /= sum;
}

double Resonances::step(double sample) {
  double sum = 0;
  for (Mode& mode : modes_) {
    const double now = sample * mode.gain + mode.feedback * mode.last + mode.loss * mode.before;
    mode.before = mode.last;
    mode.last = now;
    sum += now;
  }
  return sum;
}

}  // namespace temblor::artgen
