// Resonant materials: objects that ring when they are struck. Each is a set of modes, damped sine waves whose
// frequencies have fixed ratios that follow from the object's shape (modal synthesis).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// The modes of a material.
struct SoundMaterial {
  std::string_view name;
  // The frequencies of the modes relative to the pitch.
  std::vector<double> ratios;
  // The time in which a mode of ratio 1 loses 60 dB.
  double ring_s = 1;
  // A mode of ratio r rings r^-damping times as long: high modes fade earlier.
  double damping = 1;
};
std::span<const SoundMaterial> materials();
// Null if no material has the name.
const SoundMaterial* find_material(std::string_view name);
// "bar, bell, bone, ...", for error messages.
std::string material_names();

// The modes of a material as a bank of resonant two-pole filters in parallel. After an input sample of 1 (an
// impulse), the amplitudes of all modes add up to 1.
class Resonances {
 public:
  // How the material is tuned.
  struct Settings {
    double pitch = 440, ring_s = 1;
    // How far each mode is mistuned at random, as a fraction of its frequency.
    double spread = 0;
    std::uint64_t seed = 0;
  };
  // Modes above 0.45 of the rate are left out.
  Resonances(const SoundMaterial& material, const Settings& settings, double rate);
  // Filters one sample.
  double step(double sample);

 private:
  // y[n] = gain * x[n] + feedback * y[n-1] + loss * y[n-2]; `last` and `before` are y[n-1] and y[n-2].
  struct Mode {
    double feedback = 0, loss = 0, gain = 0, last = 0, before = 0;
  };
  std::vector<Mode> modes_;
};

}  // namespace temblor::artgen
